// SPDX-License-Identifier: GPL-3.0-or-later

// Test that pressures are fixed where all velocities of a connected part are prescribed, and only there: four triangles,
// a pair that shares an edge, a pair that shares a node; that a long strip is one part, on several ranks too; and that
// with it a direct solver gets by with such a part.

#include <lahar/assembly/fluid_assembler.h>
#include <lahar/linear/direct_solver.h>
#include <lahar/simulator/undetermined_pressures.h>

#include "tests.h"

using namespace Tests;

/// The cells that this rank knows, by local numbers.
template <int dim>
std::vector<Simplex<dim>> known_cells(const NodePartition &partition, const std::vector<Simplex<dim>> &cells)
{
  const CellList list{cells.front().data(), static_cast<unsigned int>(cells.size()), dim + 1};
  const std::vector<unsigned int> flat = partition.local_cells(0, list);
  std::vector<Simplex<dim>> result(flat.size() / (dim + 1));
  for (unsigned int i = 0; i < flat.size(); ++i)
    result[i / (dim + 1)][i % (dim + 1)] = flat[i];
  return result;
}

/// All nodes: x where the pressure is fixed. Ranks that know a node must agree.
std::string all_fixed_pressures(const NodePartition &partition,
                                const IndexVector<LocalNode, NodeConstraint<2>> &constraints)
{
  std::vector<unsigned int> n_knowing(partition.n_nodes(), 0), n_fixed(partition.n_nodes(), 0);
  for (const LocalNode l : constraints.indices())
  {
    ++n_knowing[partition.nodes()[l].value()];
    n_fixed[partition.nodes()[l].value()] += constraints[l].fixed_pressure;
  }
  Utilities::MPI::sum(n_knowing, MPI_COMM_WORLD, n_knowing);
  Utilities::MPI::sum(n_fixed, MPI_COMM_WORLD, n_fixed);
  std::string result;
  for (unsigned int i = 0; i < n_fixed.size(); ++i)
    result += n_fixed[i] == 0 ? '.' : n_fixed[i] == n_knowing[i] ? 'x' : '?';
  return result;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Nodes 0 to 3, and 4 to 8; node 9 belongs to no cell.
  const std::vector<Simplex<2>> cells = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {6, 7, 8}};
  IndexVector<RegionNode, NodeConstraint<2>> constraints(10);
  NodePartition partition(MPI_COMM_WORLD);
  partition.reinit(10, {{cells.front().data(), 4, 3}});
  const auto fixed_pressures = [&]() {
    IndexVector<LocalNode, NodeConstraint<2>> known;
    for (const RegionNode node : partition.nodes())
      known.push_back(constraints[node]);
    fix_undetermined_pressures(known_cells<2>(partition, cells), partition, known);
    return all_fixed_pressures(partition, known);
  };
  check("free parts", fixed_pressures() == "..........");
  for (const unsigned int i : {0, 1, 2, 3})
    constraints[RegionNode(i)].n_fixed = 2;
  check("a part whose velocities are all prescribed", fixed_pressures() == "xxxx......");
  constraints[RegionNode(2)].n_fixed = 1; // on a slip wall
  for (const unsigned int i : {4, 5, 6, 7})
    constraints[RegionNode(i)].n_fixed = 2;
  check("parts in which one node can move", fixed_pressures() == "..........");
  constraints[RegionNode(8)].n_fixed = 2;
  check("cells that share a node are one part", fixed_pressures() == "....xxxxx.");

  // A strip of triangles that extends over all ranks, of which one end is free.
  std::vector<Simplex<2>> strip;
  for (unsigned int i = 0; i + 2 < 60; ++i)
    strip.push_back({i, i + 1, i + 2});
  partition.reinit(60, {{strip.front().data(), 58, 3}});
  IndexVector<LocalNode, NodeConstraint<2>> known(partition.nodes().size());
  for (const LocalNode l : known.indices())
    known[l].n_fixed = partition.nodes()[l] == RegionNode(59) ? 1 : 2;
  fix_undetermined_pressures(known_cells<2>(partition, strip), partition, known);
  check("one end is free", all_fixed_pressures(partition, known) == std::string(60, '.'));
  for (const LocalNode l : known.indices())
    known[l].n_fixed = 2;
  fix_undetermined_pressures(known_cells<2>(partition, strip), partition, known);
  check("no end is free", all_fixed_pressures(partition, known) == std::string(60, 'x'));
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    return n_failed > 0;

  // A resting triangle whose nodes are all held beside one that falls.
  ParticleCloud<2> cloud;
  for (const auto &[x, y] :
       std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {0, 1}, {5, 0}, {6, 0}, {5, 1}})
    cloud.append({x, y}, ParticleKind::fluid, 1.);
  FluidMesh<2> mesh;
  mesh.reinit(cloud, {{0, 1, 2}, {3, 4, 5}});
  const auto law = make_law("Newtonian",
                            {{"Density", "1000"}, {"Viscosity", "1"}, {"Bulk modulus", "infinite"}});
  FluidState<2> state;
  state.time_step = 1e-2;
  state.velocity_factor.assign(6, 1.5);
  state.acceleration_factor.assign(6, 2. / state.time_step);
  state.old_position = state.position = cloud.position;
  state.velocity = state.old_velocity = state.acceleration = state.old_acceleration =
    std::vector<Tensor<1, 2>>(6);
  state.pressure = state.old_pressure = state.old_pressure_rate = std::vector<double>(6, 0.);
  state.gravity[1]                                              = -9.81;
  FluidAssembler<2> assembler;
  parse(assembler);
  assembler.set_stabilization(mesh, *law, state);
  BlockSystem<2> system(MPI_COMM_WORLD);
  system.reinit(6, mesh.cells());
  IndexVector<LocalNode, NodeConstraint<2>> held(6);
  for (const unsigned int i : {0, 1, 2})
    held[LocalNode(i)].n_fixed = 2;
  fix_undetermined_pressures(mesh.cells(), system.partition(), held);
  system.set_constraints(held);
  FluidAssembler<2>::Linearization linearization;
  linearization.viscosity = ViscosityLinearization::picard;
  assembler.assemble(mesh, *law, state, linearization, system);
  DirectSolver<2> solver;
  parse(solver);
  auto solution = system.make_vector();
  solver.solve(system, {}, solution);
  const auto velocities = system.velocities(solution);
  const auto pressures  = system.pressures(solution);
  for (unsigned int v = 0; v < 6; ++v)
  {
    const Tensor<1, 2> expected = v < 3 ? Tensor<1, 2>() : 1. / 200. * state.gravity;
    check("velocity", (velocities[LocalNode(v)] - expected).norm(), 1e-12);
    check("pressure", pressures[Vertex(v)], 1e-8);
  }
  return n_failed > 0;
}
