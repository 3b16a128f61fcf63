// SPDX-License-Identifier: GPL-3.0-or-later

// Test the parts of the fluid that hang together over several ranks, and sums over them, against those of one rank that
// knows all: random clouds of many parts, a chain that winds to and fro between the ranks, and particles alone.

#include <lahar/remeshing/connected_parts.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

/// Join all particles nearer than @p reach and compare sums of random contributions.
template <int dim>
void test(const std::string &name, const std::vector<Point<dim>> &points, const double reach,
          const unsigned int least, const unsigned int most)
{
  ParticleCloud<dim> cloud;
  for (const Point<dim> &point : points)
    cloud.append(point, ParticleKind::fluid, reach);
  Migration<dim> migration(MPI_COMM_WORLD);
  migration.distribute(cloud, reach, 0);

  Random random;
  std::vector<double> contribution;
  for (unsigned int i = 0; i < points.size(); ++i)
    contribution.push_back(std::round(100. * random.number())); // sums of whole numbers are exact

  // By brute force: the smallest number spreads.
  std::vector<unsigned int> part(points.size());
  for (unsigned int i = 0; i < points.size(); ++i)
    part[i] = i;
  for (bool any = true; any;)
  {
    any = false;
    for (unsigned int i = 0; i < points.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (part[i] != part[j] && points[i].distance(points[j]) < reach)
        {
          part[i] = part[j] = std::min(part[i], part[j]);
          any               = true;
        }
  }
  std::vector<double> expected(points.size(), 0.);
  unsigned int n_parts = 0;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    expected[part[i]] += contribution[i];
    n_parts += part[i] == i;
  }
  check(name + "number of parts", n_parts >= least && n_parts <= most);

  ConnectedParts<dim> parts(cloud.size());
  for (unsigned int i = 0; i < cloud.size(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      if ((cloud.is_own(i) || cloud.is_own(j)) && cloud.position[i].distance(cloud.position[j]) < reach)
        parts.join(i, j);
  parts.connect(cloud, migration);
  for (const bool at_copies : {false, true})
  {
    // Each contribution comes from one rank: the owner, or the last rank that knows the particle.
    std::vector<double> last(points.size(), 0.);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      last[cloud.number[i]] = 1. + cloud.rank;
    Utilities::MPI::max(last, MPI_COMM_WORLD, last);
    std::vector<double> here(cloud.size(), 0.);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (at_copies ? last[cloud.number[i]] == 1. + cloud.rank : cloud.is_own(i))
        here[i] = contribution[cloud.number[i]];
    const std::vector<double> sums = parts.sum(here, migration);
    double error                   = 0.;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
        error = std::max(error, std::abs(sums[i] - expected[part[cloud.number[i]]]));
    check(name + (at_copies ? "sums of what stands at copies" : "sums"), error, 0.);
  }
}

template <int dim>
void test_all()
{
  const std::string name = std::to_string(dim) + "D, ";
  Random random;
  std::vector<Point<dim>> points;
  for (unsigned int i = 0; i < 500; ++i)
    points.push_back(Point<dim>(random.vector<dim>()));
  test<dim>(name + "random: ", points, dim == 2 ? 0.07 : 0.18, 100, 300);

  // A chain that goes from end to end six times, beside it single particles.
  points.clear();
  for (unsigned int row = 0; row < 6; ++row)
  {
    for (unsigned int i = 0; i <= 60; ++i)
    {
      points.emplace_back();
      points.back()[0] = 0.1 * (row % 2 == 0 ? i : 60 - i);
      points.back()[1] = 0.3 * row;
    }
    for (unsigned int k = 1; k < 3 && row < 5; ++k)
    {
      points.push_back(points[points.size() - 1]);
      points.back()[1] += 0.1;
    }
  }
  for (unsigned int i = 0; i < 5; ++i)
  {
    points.emplace_back();
    points.back()[0] = 1.2 * i;
    points.back()[1] = -0.2;
  }
  test<dim>(name + "chain: ", points, 0.12, 6, 6);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_all<2>();
  test_all<3>();
  return n_failed > 0;
}
