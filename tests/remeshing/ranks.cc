// SPDX-License-Identifier: GPL-3.0-or-later

// Test that several ranks, each with its own particles and those around, remesh as one rank does with all of them: after
// every step of a flow that removes and inserts particles, merges surfaces and splits the fluid, the union of their own
// cells and particles is what one rank has, by the particles' numbers; disturbed clouds and lattices, with solids in the
// plane, and in space; without the correction of the volume exactly, with it up to rounding.

#include <lahar/remeshing/remesher.h>

#include <algorithm>

#include "plain_region.h"

using namespace Tests;

constexpr double h = 0.1;

template <int dim>
struct Fluid
{
  using Facet = std::array<unsigned int, dim>;

  ParticleCloud<dim> cloud;
  FluidMesh<dim> mesh;
  std::vector<Facet> contour;
  std::vector<WallFacet<dim>> floor;
  Remesher<dim> remesher;
  Migration<dim> migration;
  unsigned int n_contour = 0, n_forced = 0, n_new = 0;

  Fluid(const MPI_Comm &communicator, const bool disturbed, const bool with_solid, const bool keep_volume)
    : migration(communicator)
  {
    parse(remesher, std::string("subsection Remeshing\n set Keep volume = ") +
                      (keep_volume ? "true" : "false") + "\nend\n");
    Random random;
    if constexpr (dim == 2)
      if (with_solid)
      {
        // A square in the way, its edges as long as two spacings.
        const std::vector<Point<2>> corners{{5.2, 0.6}, {5.4, 0.6}, {5.6, 0.6}, {5.6, 0.8},
                                            {5.6, 1.},  {5.4, 1.},  {5.2, 1.},  {5.2, 0.8}};
        for (const Point<2> &corner : corners)
          cloud.append(corner, ParticleKind::solid, h);
        for (unsigned int i = 0; i < 8; ++i)
          contour.push_back({{i, (i + 1) % 8}});
        n_contour = 8;
      }
    const unsigned int n[3] = {dim == 2 ? 50U : 45U, dim == 2 ? 12U : 4U, dim == 2 ? 1U : 4U};
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
        {
          Point<dim> x;
          x[0] = h * i;
          x[1] = h * j;
          if (dim == 3)
            x[2] = h * k;
          x[dim - 1] += h;
          cloud.append(x + (disturbed ? 0.2 * h : 0.) * random.vector<dim>(), ParticleKind::fluid, h);
        }
    for (unsigned int j = 0; j < (dim == 3 ? 10U : 1U); ++j)
      for (unsigned int i = 0; i < (dim == 2 ? 100U : 70U); ++i)
      {
        Point<dim> x;
        x[0] = h * i - 1.;
        if (dim == 3)
          x[1] = h * j - 0.4;
        cloud.append(x, ParticleKind::wall, h);
      }
    if constexpr (dim == 2)
      floor.push_back({{{{9., 0.}, {-1., 0.}}}});
    migration.distribute(cloud, distance(communicator), n_contour);
    const Walls<dim> floor_walls(floor);
    remesher.create_mesh(cloud, floor_walls, contour, plain_region<dim>(floor_walls), migration, mesh);
    migration.migrate(cloud, mesh, distance(communicator), n_contour);
  }

  double distance(const MPI_Comm &communicator) const
  {
    return remesher.region_distance(cloud, mesh, n_contour > 0 ? 0.2 : 0., communicator);
  }

  Walls<dim> walls() const
  {
    std::vector<WallFacet<dim>> facets = floor;
    for (const Facet &facet : contour)
    {
      facets.emplace_back();
      for (unsigned int v = 0; v < dim; ++v)
        facets.back().corners[v] = cloud.position[facet[v]];
    }
    return Walls<dim>(facets);
  }

  /// Collapse, spread and shear; the solid turns.
  void step(const double time_step, const MPI_Comm &communicator)
  {
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      const Point<dim> &x = cloud.position[i];
      Tensor<1, dim> v;
      if (cloud.kind[i] == ParticleKind::fluid)
      {
        v[0]       = 1. + 0.3 * x[0] * (1.5 - x[dim - 1]);
        v[dim - 1] = -0.8 * x[dim - 1] + 0.5 * std::sin(6. * x[0]);
        if (dim == 3)
          v[1] = std::cos(5. * x[0]);
      }
      else if (cloud.kind[i] == ParticleKind::solid)
      {
        v[0]       = -0.3 * (x[1] - 0.8);
        v[dim - 1] = 0.3 * (x[0] - 5.4);
      }
      cloud.velocity[i] = v;
      cloud.pressure[i] = x[0];
      cloud.position[i] += time_step * v;
      if (cloud.kind[i] == ParticleKind::fluid && cloud.position[i][dim - 1] < 0.)
        cloud.position[i][dim - 1] = 0.01 * h;
    }
    mesh.move(cloud);
    migration.migrate(cloud, mesh, distance(communicator), n_contour);
    const auto report = remesher.remesh(cloud, walls(), contour, time_step, mesh, migration);
    n_forced += report.n_forced;
    n_new += std::count(report.arrives.begin(), report.arrives.end(), true);
  }

  using Cell = std::array<std::uint64_t, dim + 1>;

  std::vector<Cell> own_cells() const
  {
    std::vector<Cell> cells;
    for (const unsigned int c : mesh.own_cells(cloud))
    {
      cells.emplace_back();
      for (unsigned int I = 0; I <= dim; ++I)
        cells.back()[I] = cloud.number[mesh.particle_cells()[c][I]];
    }
    return cells;
  }

  /// Own particles: number, position, pressure.
  std::vector<std::array<double, dim + 2>> own_particles() const
  {
    std::vector<std::array<double, dim + 2>> result;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i))
      {
        result.emplace_back();
        result.back()[0] = cloud.number[i];
        for (unsigned int d = 0; d < dim; ++d)
          result.back()[1 + d] = cloud.position[i][d];
        result.back()[dim + 1] = cloud.pressure[i];
      }
    return result;
  }
};

template <typename T>
std::vector<T> gather(const std::vector<T> &own)
{
  std::vector<T> all;
  for (const auto &of_rank : Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  std::sort(all.begin(), all.end());
  return all;
}

template <int dim>
void test(const bool disturbed, const bool with_solid, const bool keep_volume)
{
  const std::string name = std::to_string(dim) + "D, " + (disturbed ? "disturbed" : "lattice") +
                           (with_solid ? " with a solid" : "") + (keep_volume ? ", volume kept" : "") + ": ";
  Fluid<dim> whole(MPI_COMM_SELF, disturbed, with_solid, keep_volume),
    parts(MPI_COMM_WORLD, disturbed, with_solid, keep_volume);
  const std::uint64_t n_at_first  = whole.cloud.next_number;
  const unsigned int n_cells_then = whole.mesh.n_cells();
  auto first_cells                = whole.own_cells();
  std::sort(first_cells.begin(), first_cells.end());
  check(name + "the same first cells", first_cells == gather(parts.own_cells()));
  bool same_cells = true, knows_around = true;
  double largest_error = 0.;
  for (unsigned int step = 0; step < 12; ++step)
  {
    whole.step(0.02, MPI_COMM_SELF);
    parts.step(0.02, MPI_COMM_WORLD);
    auto cells = whole.own_cells();
    std::sort(cells.begin(), cells.end());
    same_cells           = same_cells && cells == gather(parts.own_cells());
    const auto particles = whole.own_particles(), found = gather(parts.own_particles());
    same_cells = same_cells && particles.size() == found.size();
    for (unsigned int i = 0; i < std::min(particles.size(), found.size()); ++i)
      for (unsigned int k = 0; k < dim + 2; ++k)
        largest_error = std::max(largest_error, std::abs(particles[i][k] - found[i][k]));

    // All cells of own particles and all cells of those are known.
    std::vector<unsigned int> n_here(parts.cloud.size(), 0), n_whole(whole.cloud.size(), 0);
    for (const auto &cell : parts.mesh.particle_cells())
      for (const unsigned int i : cell)
        ++n_here[i];
    for (const auto &cell : whole.mesh.particle_cells())
      for (const unsigned int i : cell)
        ++n_whole[i];
    for (const auto &cell : parts.mesh.particle_cells())
      if (std::any_of(cell.begin(), cell.end(), [&](const unsigned int i) { return parts.cloud.is_own(i); }))
        for (const unsigned int i : cell)
          knows_around = knows_around && n_here[i] == n_whole[whole.cloud.find(parts.cloud.number[i])];
  }
  check(name + "the same cells and particles", same_cells);
  check(name + "in the same places", largest_error, keep_volume ? 1e-11 : 0.);
  check(name + "ranks know the cells around", knows_around);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  check(name + "ranks do not know all",
        n_ranks == 1 ||
          Utilities::MPI::sum(parts.cloud.size(), MPI_COMM_WORLD) < 0.9 * n_ranks * whole.cloud.size());
  check(name + "particles were inserted", whole.cloud.next_number > n_at_first + 10);
  check(name + "and removed", whole.cloud.size() < whole.cloud.next_number - 5);
  check(name + "cells are new", whole.n_new > 5 && whole.mesh.n_cells() != n_cells_then);
  check(name + "numbers of new cells' corners",
        Utilities::MPI::sum(parts.n_new, MPI_COMM_WORLD) >= whole.n_new);
  if (with_solid)
    check(name + "contour facets were mended, the same number",
          whole.n_forced > 0 && Utilities::MPI::sum(parts.n_forced, MPI_COMM_WORLD) == whole.n_forced);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool disturbed : {true, false})
  {
    test<2>(disturbed, false, false);
    test<2>(disturbed, true, false);
    test<3>(disturbed, false, false);
  }
  test<2>(true, true, true);
  test<3>(true, false, true);
  return n_failed > 0;
}
