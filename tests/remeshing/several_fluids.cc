// SPDX-License-Identifier: GPL-3.0-or-later

// Test which fluid a cell belongs to, what becomes of an interface in the plane when particles come and go, that a layered
// block that is sheared and mixed up keeps the area of each fluid and an interface of particles of both, and that ranks that
// see one fluid only give new particles the fluids that one rank gives them.

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/cell_fluid.h>
#include <lahar/remeshing/interface_segments.h>
#include <lahar/remeshing/remesher.h>

#include <algorithm>

#include "tests.h"
#include "two_layers.h"

using namespace Tests;

void test_rule()
{
  ParticleCloud<2> cloud;
  const auto add = [&](const FluidSet fluids, const ParticleKind kind = ParticleKind::fluid) {
    return cloud.append(Point<2>(), kind, 1., fluids);
  };
  const unsigned int a = add(1), a2 = add(1), b = add(2), both = add(3), both2 = add(3), both3 = add(3),
                     wall = add(5, ParticleKind::wall), wall2 = add(7, ParticleKind::wall);
  const auto fluid = [&](const Simplex<2> &cell, const std::optional<unsigned int> before) {
    return fluid_of_cell<2>(cell, cloud, [&] { return before; });
  };
  check("one fluid", fluid({{b, wall, wall2}}, 0U) == 1 && fluid({{a, a2, wall}}, 1U) == 0);
  check("the shared fluid", fluid({{b, both, both2}}, 0U) == 1 && fluid({{a, both, wall}}, 1U) == 0);
  check("on the interface what was there", fluid({{both, both2, both3}}, 1U) == 1 &&
                                             fluid({{both, wall, wall2}}, 0U) == 0 &&
                                             fluid({{both, both2, wall}}, std::nullopt) == 0);
  check("where fluids meet most corners", fluid({{a, a2, b}}, 1U) == 0 && fluid({{a2, a, b}}, {}) == 0);
  check("else what was there",
        fluid({{a, b, both}}, 1U) == 1 && fluid({{a, b, wall}}, 0U) == 0 && fluid({{a, b, wall}}, {}) == 0);
}

/// Two fluids, the second one above y = 1/2, in the unit square.
struct Layers
{
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  const unsigned int n = 10;

  Layers()
  {
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        cloud.append(Point<2>(i + (j % 2 == 0 || i == 0 || i == n ? 0. : 0.2), j) / double(n),
                     ParticleKind::fluid, 1. / n,
                     2 * j < n   ? 1U
                     : 2 * j > n ? 2U
                                 : 3U);
    mesh_layers(cloud, true, mesh);
  }
};

void test_segments()
{
  Layers layers;
  const auto faces  = find_interface_faces(layers.mesh);
  bool on_interface = true, lower_on_left = true;
  for (const auto &face : faces)
  {
    const Point<2> &from = layers.cloud.position[face.corners[0]],
                   &to   = layers.cloud.position[face.corners[1]];
    on_interface         = on_interface && from[1] == 0.5 && to[1] == 0.5;
    lower_on_left = lower_on_left && to[0] < from[0] && layers.cloud.position[face.opposite[0]][1] < 0.5;
  }
  check("the interface has its faces", faces.size() == layers.n && on_interface && lower_on_left);

  layers.cloud.position[5 * (layers.n + 1) + 2][0] += 0.04; // so that no edge is longer than 2 h
  OldDomain<2> old_domain(layers.cloud, layers.mesh);
  const unsigned int row = 5 * (layers.n + 1);
  // Remove one particle of the interface and divide another edge of it.
  const unsigned int middle = layers.cloud.append_midpoint(row + 6, row + 7);
  check("a particle in an edge of the interface is of both fluids", layers.cloud.part[middle] == 3);
  std::vector<bool> removed(layers.cloud.size(), false);
  removed[row + 3]                    = true;
  std::vector<unsigned int> new_index = layers.cloud.remove(removed);
  new_index.pop_back();
  old_domain.renumber(new_index, {{row + 6, row + 7}}, layers.cloud.size());
  auto segments = find_interface_segments(faces, old_domain, layers.cloud, 1., {});
  double length = 0.;
  for (const auto &[from, to] : segments)
    length += layers.cloud.position[from].distance(layers.cloud.position[to]);
  check("it stays in one piece", segments.size() == layers.n);
  check("of the same length", length - 1., 1e-14);
  segments = find_interface_segments(faces, old_domain, layers.cloud, 0.15, {});
  check("but for edges that are too long", segments.size() == layers.n - 1);
  const unsigned int below = 4 * (layers.n + 1) + 1, above = row + layers.n;
  segments = find_interface_segments(faces, old_domain, layers.cloud, 1., {{{below, above}}});
  check("and those that cross another segment", segments.size() == layers.n - 1);
}

void test_remeshing()
{
  Layers layers;
  Remesher<2> remesher;
  parse(remesher, "");
  remesher.set_number_of_fluids(2);
  const std::vector<double> before = layers.mesh.volumes(layers.cloud, 2);
  double largest = 0., overlap = 0., n_corners = 0.;
  for (unsigned int step = 0; step < 40; ++step)
  {
    // A vortex that turns the interface over, without change of areas but for the steps' length.
    for (unsigned int i = 0; i < layers.cloud.size(); ++i)
    {
      Point<2> &x         = layers.cloud.position[i];
      const auto velocity = [](const Point<2> &y) {
        return Tensor<1, 2>({std::sin(numbers::PI * y[0]) * std::cos(numbers::PI * y[1]),
                             -std::cos(numbers::PI * y[0]) * std::sin(numbers::PI * y[1])});
      };
      x += 0.02 * velocity(x + 0.01 * velocity(x));
    }
    layers.mesh.move(layers.cloud);
    const std::vector<double> moved = layers.mesh.volumes(layers.cloud, 2);
    remesher.remesh(layers.cloud, Walls<2>(), {}, 1e-3, layers.mesh);
    const std::vector<double> now = layers.mesh.volumes(layers.cloud, 2);
    largest                       = std::max(largest, std::abs(now[0] - moved[0]));
    for (unsigned int c = 0; c < layers.mesh.n_cells(); ++c)
      for (const unsigned int i : layers.mesh.particle_cells()[c])
      {
        ++n_corners;
        overlap += (layers.cloud.part[i] & fluid_set(layers.mesh.fluid(c))) == 0U;
      }
  }
  const std::vector<double> after = layers.mesh.volumes(layers.cloud, 2);
  check("a step of remeshing changes a fluid's area by less than a cell", largest,
        0.5 / (layers.n * layers.n));
  check("all steps do", std::abs(after[0] - before[0]) + std::abs(after[1] - before[1]), 1e-2);
  check("hardly any cell has a corner of other fluids only", overlap / n_corners, 1e-3);
}

/// A long strip of the first fluid with the second one at its end, and particles of both within the first one, as a film of
/// the second one that has torn leaves them; it is stretched until edges are divided.
struct Strip
{
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  Migration<2> migration;

  Strip(const MPI_Comm &communicator)
    : migration(communicator)
  {
    constexpr unsigned int n = 60, n_first = 50;
    constexpr double h = 0.1;
    Remesher<2> remesher;
    parse(remesher, "");
    remesher.set_number_of_fluids(2);
    for (unsigned int j = 0; j < 5; ++j)
      for (unsigned int i = 0; i < n; ++i)
        cloud.append(Point<2>(h * i, h * j), ParticleKind::fluid, h,
                     i > n_first                         ? 2U
                     : i == n_first || (j >= 2 && i < 9) ? 3U
                                                         : 1U);
    const auto distance = [&] { return remesher.region_distance(cloud, mesh, 0., communicator); };
    migration.distribute(cloud, distance(), 0);
    remesher.create_mesh(
      cloud, Walls<2>(), {}, [](const Simplex<2> &, const ParticleCloud<2> &) { return true; }, migration,
      mesh);
    std::vector<unsigned int> fluids;
    for (const Simplex<2> &cell : mesh.particle_cells())
      fluids.push_back(centroid<2>(corners_of<2>(cell, cloud.position))[0] > h * n_first);
    mesh.set_cell_fluids(fluids);
    migration.migrate(cloud, mesh, distance(), 0);
    for (Point<2> &x : cloud.position)
      x[0] *= 1.6;
    mesh.move(cloud);
    migration.migrate(cloud, mesh, distance(), 0);
    sees_one_fluid = mesh.cell_fluids().empty();
    remesher.remesh(cloud, Walls<2>(), {}, 1e-3, mesh, migration);
  }

  bool sees_one_fluid;

  /// Number and fluids of this rank's particles.
  std::vector<std::pair<std::uint64_t, FluidSet>> own_particles() const
  {
    std::vector<std::pair<std::uint64_t, FluidSet>> result;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
        result.emplace_back(cloud.number[i], cloud.part[i]);
    return result;
  }
};

void test_ranks()
{
  const Strip whole(MPI_COMM_SELF), parts(MPI_COMM_WORLD);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const unsigned int n_blind = Utilities::MPI::sum(parts.sees_one_fluid ? 1U : 0U, MPI_COMM_WORLD);
  check("of several ranks one sees one fluid", n_blind == (n_ranks > 1 ? 1U : 0U));
  const auto expected = whole.own_particles();
  std::vector<std::pair<std::uint64_t, FluidSet>> found;
  for (const auto &of_rank : Utilities::MPI::all_gather(MPI_COMM_WORLD, parts.own_particles()))
    found.insert(found.end(), of_rank.begin(), of_rank.end());
  std::sort(found.begin(), found.end());
  const unsigned int n_new = whole.cloud.size() - 5 * 60;
  check("particles are new", n_new > 20 && n_new < 1000);
  check("they are of the same fluids on ranks", found == expected);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_rule();
  test_segments();
  test_remeshing();
  test_ranks();
  return n_failed > 0;
}
