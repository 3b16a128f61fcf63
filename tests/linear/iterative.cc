// SPDX-License-Identifier: GPL-3.0-or-later

// Test the iterative solver against the direct one on the system of a Newton step of a Bingham fluid: a sheared layer
// below a plug whose viscosity is 10^8 times the plastic one, in 2D and 3D, with both preconditioners.

#include <deal.II/base/utilities.h>

#include <lahar/assembly/fluid_assembler.h>
#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/linear/direct_solver.h>
#include <lahar/linear/iterative_solver.h>

#include "tests.h"

using namespace Tests;

/// A cube with n particles of 1 cm spacing along each edge, shaken, open at the top.
template <int dim>
void make_mesh(const unsigned int n, ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh)
{
  Random random;
  const double h = 0.01;
  for (unsigned int k = 0; k < Utilities::fixed_power<dim>(n + 1); ++k)
  {
    Point<dim> p;
    bool inside = true, wall = false;
    for (unsigned int d = 0, rest = k; d < dim; ++d, rest /= n + 1)
    {
      p[d]   = rest % (n + 1);
      inside = inside && p[d] > 0 && p[d] < n;
      wall   = wall || p[d] == 0 || (p[d] == n && d < dim - 1);
    }
    if (inside)
      p += 0.2 * random.vector<dim>();
    cloud.append(Point<dim>(h * p), wall ? ParticleKind::wall : ParticleKind::fluid, h);
  }
  std::vector<Simplex<dim>> cells;
  for (const Simplex<dim> &simplex : delaunay(cloud.position))
    if (signed_volume<dim>(corners_of<dim>(simplex, cloud.position)) > 1e-6 * std::pow(h, dim))
      cells.push_back(simplex);
  mesh.reinit(cloud, cells);
}

template <int dim>
void test(const unsigned int n)
{
  const std::string name = Utilities::int_to_string(dim) + "D ";
  ParticleCloud<dim> cloud;
  FluidMesh<dim> mesh;
  make_mesh(n, cloud, mesh);
  const auto law = make_law("Bingham", {{"Density", "1000"},
                                        {"Plastic viscosity", "0.001"},
                                        {"Yield stress", "100"},
                                        {"Regularization parameter", "1000"}});

  // The state of all vertices is known to all ranks; each assembles its part.
  BlockSystem<dim> system(MPI_COMM_WORLD);
  IndexVector<RegionNode, Point<dim>> positions;
  std::vector<unsigned int> owners;
  std::vector<std::uint64_t> keys;
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  for (const unsigned int particle : mesh.particles())
  {
    positions.push_back(cloud.position[particle]);
    owners.push_back(std::min<unsigned int>(cloud.position[particle][0] / (0.01 * n) * n_ranks, n_ranks - 1));
    keys.push_back(particle);
  }
  system.reinit(mesh.n_vertices(), mesh.cells(), {}, positions, {owners, keys});
  FluidMesh<dim> part;
  std::vector<unsigned int> known;
  for (const RegionNode node : system.partition().nodes())
    known.push_back(node.value());
  part.reinit_part(mesh, known, system.cells());

  const unsigned int n_vertices = part.n_vertices();
  const double depth            = 0.01 * n;
  FluidState<dim> state;
  state.gravity[dim - 1] = -9.81;
  IndexVector<LocalNode, NodeConstraint<dim>> constraints(n_vertices);
  state.time_step = 1e-3;
  state.velocity_factor.assign(n_vertices, 1.5);
  state.acceleration_factor.assign(n_vertices, 2. / state.time_step);
  state.velocity.resize(n_vertices);
  for (unsigned int v = 0; v < n_vertices; ++v)
  {
    const Point<dim> &x = cloud.position[part.particle(v)];
    state.position.push_back(x);
    state.pressure.push_back(-9810. * (depth - x[dim - 1]));
    if (cloud.kind[part.particle(v)] == ParticleKind::wall)
      constraints[LocalNode(v)].n_fixed = dim;
    else
      state.velocity[v][0] = std::min(x[dim - 1], 0.4 * depth);
  }
  state.old_position = state.position;
  state.old_velocity = state.acceleration = state.old_acceleration = std::vector<Tensor<1, dim>>(n_vertices);
  state.old_pressure = state.old_pressure_rate = state.pressure;

  FluidAssembler<dim> assembler;
  parse(assembler);
  assembler.set_stabilization(part, *law, state);
  IndexVector<LocalNode, Tensor<1, dim>> projection(state.residual_projection);
  system.partition().update(projection);
  state.residual_projection = projection.raw();
  assembler.start_plastic_dual(part, *law, state);
  system.set_constraints(constraints);
  assembler.assemble(part, *law, state, {}, system);

  auto reference = system.make_vector(), solution = system.make_vector();
  DirectSolver<dim> direct;
  parse(direct);
  direct.solve(system, {}, reference);
  const double v_scale = reference.block(0).l2_norm(), p_scale = reference.block(1).l2_norm();

  for (const std::string preconditioner : {"ML", "ILU"})
  {
    const std::string entries = "set Preconditioner = " + preconditioner + "\n";
    IterativeSolver<dim> solver;
    parse(solver, entries + "set Tolerance = 1e-9\n");
    const unsigned int n_iterations = solver.solve(system, {v_scale, p_scale}, solution);
    check(name + preconditioner + ": iterations are counted and few", n_iterations > 1 && n_iterations < 80);
    solution.block(0) -= reference.block(0);
    solution.block(1) -= reference.block(1);
    check(name + preconditioner + ": velocity equals the direct solution's",
          solution.block(0).l2_norm() / v_scale, 1e-6);
    check(name + preconditioner + ": pressure equals the direct solution's",
          solution.block(1).l2_norm() / p_scale, 1e-6);

    auto by_blocks = system.make_vector();
    direct.start_blocks(system);
    solver.start_blocks(system);
    for (unsigned int b = 0; b < 2; ++b)
    {
      direct.solve_block(b, system.right_hand_side().block(b), by_blocks.block(b));
      solver.solve_block(b, system.right_hand_side().block(b), solution.block(b));
      solution.block(b) -= by_blocks.block(b);
      check(name + preconditioner + ": one block alone",
            solution.block(b).l2_norm() / by_blocks.block(b).l2_norm(), 1e-5);
    }

    const unsigned int n_sweeps        = solver.solve_in_two_steps(system, {v_scale, p_scale}, solution),
                       n_direct_sweeps = direct.solve_in_two_steps(system, {v_scale, p_scale}, by_blocks);
    check(name + preconditioner + ": as many sweeps with factors and with GMRES for the blocks",
          n_sweeps > 1 && n_sweeps < 10 && n_direct_sweeps == n_sweeps);
    for (unsigned int b = 0; b < 2; ++b)
    {
      by_blocks.block(b) -= reference.block(b);
      solution.block(b) -= reference.block(b);
      const double scale = b == 0 ? v_scale : p_scale;
      check(name + preconditioner + ": sweeps come near the direct solution",
            std::max(by_blocks.block(b).l2_norm(), solution.block(b).l2_norm()) / scale, 0.1);
    }

    IterativeSolver<dim> impatient;
    parse(impatient, entries + "set Maximum iterations = 1\n");
    check_throws<RunError>(name + preconditioner + ": too many iterations", {"GMRES", "1 iteration"}, [&]() {
      impatient.solve(system, {v_scale, p_scale}, solution);
    });
  }
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(24);
  test<3>(7);
  return n_failed;
}
