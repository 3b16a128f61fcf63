// SPDX-License-Identifier: GPL-3.0-or-later

// Test which cells are slivers, and the terms of one that turns inside out: its mass rows have the change of its signed
// volume, their derivatives and the pressure's force those of the volume, and the assembly of such a mesh is possible.

#include <lahar/assembly/fluid_assembler.h>
#include <lahar/assembly/terms.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/simulator/slivers.h>

#include "assembly/one_cell.h"

using namespace Tests;

/// Four corners of a square of edge 1, two opposite ones raised by @p height; the corners of one diagonal are of the given
/// kinds.
std::vector<bool> slivers_of_square(const double height, const ParticleKind first, const ParticleKind second)
{
  ParticleCloud<3> cloud;
  cloud.append(Point<3>(0., 0., 0.), first, 1.);
  cloud.append(Point<3>(1., 0., height), ParticleKind::fluid, 1.);
  cloud.append(Point<3>(0., 1., height), ParticleKind::fluid, 1.);
  cloud.append(Point<3>(1., 1., 0.), second, 1.);
  Simplex<3> cell = {{0, 1, 2, 3}};
  if (signed_volume<3>(corners_of<3>(cell, cloud.position)) < 0.)
    std::swap(cell[2], cell[3]);
  FluidMesh<3> mesh;
  mesh.reinit(cloud, {cell});
  return find_slivers(mesh, cloud);
}

void test_rule()
{
  // V = height/3, mean edge about (4 + 2 √2)/6 = 1.14, so that the rule's bound is a height of 0.105.
  const auto fluid = ParticleKind::fluid, wall = ParticleKind::wall, solid = ParticleKind::solid;
  check("a flat cell is a sliver", slivers_of_square(0.09, fluid, fluid)[0]);
  check("one of more height is none", !slivers_of_square(0.12, fluid, fluid)[0]);
  check("nor is a regular one", !slivers_of_square(1., fluid, fluid)[0]);
  check("one corner may be a wall's", slivers_of_square(0.09, wall, fluid)[0]);
  check("two may not: it is contact", !slivers_of_square(0.09, wall, wall)[0]);
  check("nor of a wall and a solid", !slivers_of_square(0.09, wall, solid)[0]);

  ParticleCloud<2> cloud;
  cloud.append(Point<2>(0., 0.), fluid, 1.);
  cloud.append(Point<2>(1., 0.), fluid, 1.);
  cloud.append(Point<2>(0.5, 1e-3), fluid, 1.);
  FluidMesh<2> mesh;
  mesh.reinit(cloud, {{{0, 1, 2}}});
  check("there are none in the plane", !find_slivers(mesh, cloud)[0]);
}

template <int dim>
void test_terms()
{
  const std::string name = Utilities::int_to_string(dim) + "D ";
  Random random;
  const auto law = make_law("Newtonian", {{"Density", "1000"}, {"Viscosity", "0.001"}});
  SimplexCorners<dim> start, end;
  do
    for (Point<dim> &x : start)
      x = Point<dim>(random.vector<dim>());
  while (signed_volume<dim>(start) < 0.1);
  // The last corner passes to the other side of the others.
  end             = start;
  Point<dim> foot = centroid<dim>(start);
  foot += (foot - start[dim]) / dim;
  end[dim] = foot + 0.3 * (foot - start[dim]);
  for (Point<dim> &x : end)
    x += 0.01 * random.vector<dim>();
  check(name + "the cell is inside out", signed_volume<dim>(end) < 0.);

  OneCell<dim> example(*law, 1e-2);
  example.state.sliver = {true};
  for (unsigned int I = 0; I <= dim; ++I)
  {
    example.state.old_position[I]    = start[I];
    example.state.position[I]        = end[I];
    example.state.pressure[I]        = 100. * random.number();
    example.state.velocity_factor[I] = 1.5;
  }
  const FluidCell<dim> cell = example.cell();
  check(name + "it has the shape of the start", cell.volume() - signed_volume<dim>(start), 0.);
  check(name + "which does not move", cell.motion(), 0.);
  CellSystem<dim> system;
  system.clear();
  FlatPressureDivergence<dim>().assemble(cell, end, system);

  using S       = CellSystem<dim>;
  double growth = 0., force_error = 0., derivative_error = 0., gradient_error = 0.;
  for (unsigned int I = 0; I <= dim; ++I)
  {
    growth -= system.residual[S::pressure_index(I)];
    for (unsigned int a = 0; a < dim; ++a)
    {
      // The volume is linear in each coordinate: the difference is exact but for rounding.
      const double step         = 0.1;
      SimplexCorners<dim> moved = end;
      moved[I][a] += step;
      const double derivative = (signed_volume<dim>(moved) - signed_volume<dim>(end)) / step;
      force_error             = std::max(force_error,
                                         std::abs(system.residual[S::index(I, a)] - cell.mean_pressure() * derivative));
      for (unsigned int J = 0; J <= dim; ++J)
      {
        derivative_error =
          std::max(derivative_error,
                   std::abs(system.matrix[S::pressure_index(J)][S::index(I, a)] + derivative / (dim + 1)));
        gradient_error = std::max(gradient_error,
                                  std::abs(system.matrix[S::pressure_index(J)][S::index(I, a)] +
                                           system.matrix[S::index(I, a)][S::pressure_index(J)]));
      }
    }
  }
  check(name + "the mass rows sum to the change of the volume",
        growth * cell.time_step() - (signed_volume<dim>(end) - signed_volume<dim>(start)), 1e-13);
  check(name + "their derivatives are those of the volume", derivative_error, 1e-13);
  check(name + "the pressure's force does its work on the volume", force_error, 1e-11);
  check(name + "Q and C are transposed", gradient_error, 1e-15);

  // Where nothing moves, the term is that of any cell.
  CellSystem<dim> flat, other;
  flat.clear();
  other.clear();
  FlatPressureDivergence<dim>().assemble(cell, start, flat);
  PressureDivergence<dim>().assemble(cell, other);
  double difference = 0.;
  for (unsigned int i = 0; i < S::n_unknowns; ++i)
  {
    difference = std::max(difference, std::abs(flat.residual[i] - other.residual[i]));
    for (unsigned int j = 0; j < S::n_unknowns; ++j)
      difference = std::max(difference, std::abs(flat.matrix[i][j] - other.matrix[i][j]));
  }
  check(name + "a cell that has not moved has the terms of any cell", difference, 1e-11);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_rule();
  test_terms<2>();
  test_terms<3>();
  return n_failed > 0;
}
