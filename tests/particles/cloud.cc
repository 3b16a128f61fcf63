// SPDX-License-Identifier: GPL-3.0-or-later

// Test the particle cloud: append, append_midpoint and remove keep all arrays consistent; records carry all of a particle.

#include <deal.II/base/numbers.h>

#include <lahar/particles/particle_cloud.h>

#include "tests.h"

using namespace Tests;

template <int dim>
void test()
{
  ParticleCloud<dim> cloud;
  const auto is_consistent = [&]() {
    const std::size_t n = cloud.size();
    return cloud.velocity.size() == n && cloud.acceleration.size() == n && cloud.pressure.size() == n &&
           cloud.pressure_rate.size() == n && cloud.kind.size() == n && cloud.spacing.size() == n &&
           cloud.contact_facets.size() == n && cloud.structure[0].size() == n;
  };

  cloud.structure.resize(2);
  Random random;
  for (unsigned int i = 0; i < 6; ++i)
  {
    const unsigned int index = cloud.append(Point<dim>(random.vector<dim>()),
                                            i < 2 ? ParticleKind::wall : ParticleKind::fluid, 0.1 * (i + 1));
    AssertThrow(index == i, ExcInternalError());
    check("a new particle is at rest, without pressure and contact",
          cloud.velocity[i].norm() == 0. && cloud.acceleration[i].norm() == 0. && cloud.pressure[i] == 0. &&
            cloud.pressure_rate[i] == 0. && !cloud.in_contact(i));
    cloud.velocity[i]                 = random.vector<dim>();
    cloud.acceleration[i]             = random.vector<dim>();
    cloud.algorithmic_acceleration[i] = random.vector<dim>();
    cloud.owed_volume[i]              = random.number();
    cloud.pressure[i]                 = random.number();
    cloud.pressure_rate[i]            = random.number();
    cloud.structure[0][i]             = i;
  }
  cloud.structure[1][5] = 7.;
  check("numbers of each kind", cloud.n_particles(ParticleKind::wall) == 2 &&
                                  cloud.n_particles(ParticleKind::fluid) == 4 &&
                                  cloud.n_particles(ParticleKind::solid) == 0);

  // Both slide on facet 7, each on one more.
  cloud.contact_facets[2][0] = 4;
  cloud.contact_facets[2][1] = 7;
  cloud.contact_facets[5][0] = 7;
  cloud.contact_facets[5][1] = 9;
  const unsigned int m       = cloud.append_midpoint(2, 5);
  const double error =
    (cloud.position[m] - cloud.position[2] - 0.5 * (cloud.position[5] - cloud.position[2])).norm() +
    (cloud.velocity[m] - 0.5 * (cloud.velocity[2] + cloud.velocity[5])).norm() +
    (cloud.acceleration[m] - 0.5 * (cloud.acceleration[2] + cloud.acceleration[5])).norm() +
    std::abs(cloud.pressure[m] - 0.5 * (cloud.pressure[2] + cloud.pressure[5])) +
    std::abs(cloud.pressure_rate[m] - 0.5 * (cloud.pressure_rate[2] + cloud.pressure_rate[5])) +
    std::abs(cloud.spacing[m] - 0.45);
  check("a particle in the middle has the mean state", error, 1e-15);
  check("it is fluid and slides on the shared facet alone",
        cloud.kind[m] == ParticleKind::fluid && cloud.contact_facets[m][0] == 7 &&
          cloud.contact_facets[m][1] == ParticleCloud<dim>::no_facet && cloud.in_contact(m));
  check("it has the mean structure of those that have one",
        cloud.structure[0][m] == 3.5 && cloud.structure[1][m] == 7.);
  const unsigned int at_wall = cloud.append_midpoint(0, 1);
  check("between wall particles: fluid as well", cloud.kind[at_wall] == ParticleKind::fluid && at_wall == 7);
  check("without structure if both have none",
        cloud.structure[1][at_wall] == ParticleCloud<dim>::no_structure);
  check("arrays have one length", is_consistent());

  const ParticleCloud<dim> before = cloud;
  const std::vector<bool> removed = {false, true, false, true, true, false, false, true};
  const auto new_index            = cloud.remove(removed);
  bool kept_order = true, same = true;
  unsigned int n = 0;
  for (unsigned int i = 0; i < removed.size(); ++i)
  {
    kept_order = kept_order && new_index[i] == (removed[i] ? numbers::invalid_unsigned_int : n++);
    if (!removed[i])
    {
      const unsigned int k = new_index[i];
      same = same && cloud.position[k] == before.position[i] && cloud.velocity[k] == before.velocity[i] &&
             cloud.acceleration[k] == before.acceleration[i] && cloud.pressure[k] == before.pressure[i] &&
             cloud.pressure_rate[k] == before.pressure_rate[i] && cloud.kind[k] == before.kind[i] &&
             cloud.spacing[k] == before.spacing[i] && cloud.contact_facets[k] == before.contact_facets[i] &&
             cloud.structure[0][k] == before.structure[0][i];
    }
  }
  check("remove keeps the order of the others", kept_order && cloud.size() == 4);
  check("remove keeps their state", same && is_consistent());

  // The first of two records of a number counts; order by number.
  ParticleCloud<dim> copy;
  copy.rank        = 3;
  copy.next_number = 99;
  copy.structure.resize(2);
  std::vector<double> records;
  for (const unsigned int i : {7, 2, 5, 0})
    before.append_record(i, records);
  for (const unsigned int i : {5, 2})
  {
    before.append_record(i, records);
    records[records.size() - before.record_size()] = 1e3;
  }
  copy.reinit(records);
  const auto record = [](const ParticleCloud<dim> &of, const unsigned int i) {
    std::vector<double> result;
    of.append_record(i, result);
    return result;
  };
  same                           = copy.size() == 4 && copy.rank == 3 && copy.next_number == 99;
  const unsigned int expected[4] = {0, 2, 5, 7};
  for (unsigned int k = 0; k < 4 && same; ++k)
    same = copy.number[k] == expected[k] && record(copy, k) == record(before, expected[k]) &&
           copy.find(expected[k]) == k;
  check("records make a cloud", same && copy.find(3) == numbers::invalid_unsigned_int);

  cloud.remove(std::vector<bool>(4, true));
  check("remove all", cloud.size() == 0 && is_consistent());
}

int main()
{
  test<2>();
  test<3>();
  return n_failed;
}
