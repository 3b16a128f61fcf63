// SPDX-License-Identifier: GPL-3.0-or-later

// Test that multipliers of an exact yield stress stay within their fluid when a layered block is remeshed: new cells have
// the mean over the cells of their own fluid alone, kept ones keep theirs unless they change the fluid.

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/plastic_multipliers.h>
#include <lahar/remeshing/remesher.h>

#include "tests.h"

using namespace Tests;

using Value = SymmetricTensor<2, 2>;

/// Λ of the lower fluid, of the upper one.
const std::array<Value, 2> of_fluids = {
  {Value(Tensor<2, 2>({{0.8, 0.1}, {0.1, -0.8}})), Value(Tensor<2, 2>({{-0.2, 0.5}, {0.5, 0.2}}))}};

constexpr unsigned int n = 8;

unsigned int fluid_at(const Simplex<2> &cell, const ParticleCloud<2> &cloud)
{
  return centroid<2>(corners_of<2>(cell, cloud.position))[1] > 0.5;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ParticleCloud<2> cloud;
  Random random;
  for (unsigned int j = 0; j <= n; ++j)
    for (unsigned int i = 0; i <= n; ++i)
    {
      Point<2> x(double(i) / n, double(j) / n);
      if (i > 0 && i < n)
        x[0] += 0.2 / n * random.number();
      if (j > 0 && j < n && 2 * j != n)
        x[1] += 0.2 / n * random.number();
      cloud.append(x, ParticleKind::fluid, 1. / n, 2 * j < n ? 1U : 2 * j > n ? 2U : 3U);
    }
  std::vector<Simplex<2>> cells;
  std::vector<unsigned int> fluids;
  for (const Simplex<2> &cell : delaunay<2>(cloud.position))
    if (signed_volume<2>(corners_of<2>(cell, cloud.position)) > 1e-6)
    {
      cells.push_back(cell);
      fluids.push_back(fluid_at(cell, cloud));
    }
  FluidMesh<2> mesh;
  mesh.reinit(cloud, cells, fluids);
  std::vector<Value> values;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    values.push_back(of_fluids[mesh.fluid(c)]);
  PlasticMultipliers<2> multipliers;
  multipliers.set(mesh, cloud, values);

  // A shear that turns many of the cells' diagonals.
  Remesher<2> remesher;
  parse(remesher, "");
  remesher.set_number_of_fluids(2);
  const Migration<2> alone;
  unsigned int n_new = 0;
  double error       = 0.;
  for (unsigned int step = 0; step < 10; ++step)
  {
    for (Point<2> &x : cloud.position)
      x[0] += 0.1 * x[1];
    mesh.move(cloud);
    multipliers.spread(mesh, 2, cloud, alone);
    remesher.remesh(cloud, Walls<2>(), {}, 1e-3, mesh);
    multipliers.follow(mesh, cloud);
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const auto key = CellTable<2>::key(mesh.particle_cells()[c], cloud);
      n_new += multipliers.table().find(key) == nullptr;
      error = std::max(error, (multipliers.values()[c] - of_fluids[mesh.fluid(c)]).norm());
    }
    multipliers.set(mesh, cloud, multipliers.values());
  }
  check("cells are new", n_new > 50);
  check("each has what its own fluid had", error, 1e-14);

  // The same cells, but those at the interface change sides: nothing is known of them in their new fluid but at corners.
  multipliers.spread(mesh, 2, cloud, alone);
  std::vector<unsigned int> swapped = mesh.cell_fluids();
  for (unsigned int &fluid : swapped)
    fluid = 1 - fluid;
  mesh.set_cell_fluids(swapped);
  multipliers.follow(mesh, cloud);
  double largest = 0., other = 0.;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
  {
    const Value &value = multipliers.values()[c];
    largest            = std::max(largest, std::min(value.norm(), (value - of_fluids[mesh.fluid(c)]).norm()));
    other              = std::max(other, value.norm());
  }
  check("a cell that changes its fluid has nothing of the old one", largest, 1e-14);
  check("but of the new one if it is beside it", other > 0.5);
  return n_failed > 0;
}
