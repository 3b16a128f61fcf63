// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/step_problem.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    // What increments are compared with at least: velocities, with this part of what gravity makes in a step and of the
    // speed of sound in solids; pressures, with those that make this part of the velocities.
    constexpr double negligible_acceleration = 1e-3;
    constexpr double negligible_sound        = 1e-8;
  } // namespace



  template <int dim>
  void StepProblem<dim>::start_step(const Start &start)
  {
    region_mesh = &start.mesh;
    materials   = start.materials;
    integration.start_step(start.time_step, start.is_first);
    const double end_time = start.time + start.time_step;
    solid.start(start.solids, *region_mesh, integration.with_gamma(start.solids.newmark_gamma()), end_time);
    contact.start_step(start.touches, *region_mesh, start.cloud, materials, start.time_step);
    set_constraints(start, reinit_system(start.cloud, start.migration));
    linear_solver->forget();

    IndexVector<Vertex, bool> impulsive;
    for (const Vertex v : numbering.vertices())
      impulsive.push_back(start.arrives[numbering.region_vertex(v).value()] ||
                          constraints[numbering.node(v)].n_fixed == dim);
    fluid.start(*mesh, start.cloud, integration, start.gravity, impulsive);
    fluid.state.face_pressures = start.outlets.pressures(*mesh, start.cloud, end_time,
                                                         materials.largest_density() * start.gravity);
    friction.start_step(start.sliding,
                        {*region_mesh, start.cloud, start.materials, start.gravity, start.time_step},
                        numbering, communicator());
    contact.number(system, numbering);
    friction.join(contact);
    step_state.start_step(constraints.size(), mesh->n_vertices(), floors(start.cloud));

    fluid.state.structure.clear();
    if (!start.structure.empty())
      for (const unsigned int c : system.cells())
        fluid.state.structure.push_back(start.structure[c]);
    if (materials.any_exact_yield_stress())
      start_multipliers(start.multipliers);
    assembler.set_stabilization(*mesh, materials, fluid.state);
    // There is no pressure yet: the residual is the weight, not the divergence of a stress.
    if (integration.is_first_step())
      fluid.state.residual_projection.assign(materials.n_fluids() * mesh->n_vertices(), Tensor<1, dim>());
    update_by_fluid(fluid.state.residual_projection);
    if (materials.any_yields())
      assembler.start_plastic_dual(*mesh, materials, fluid.state);
    IndexVector<LocalNode, Tensor<1, dim>> velocities = node_velocities();
    impose(velocities);
    safeguards.slow_down(constraints, fluid, velocities);
    move_solids(velocities);
    if (contact.any())
    {
      contact.close_gaps(numbering, constraints, velocities);
      fluid.move(numbering.by_vertex(velocities));
      move_solids(velocities);
    }
    set_norms();
  }



  template <int dim>
  void StepProblem<dim>::impose(IndexVector<LocalNode, Tensor<1, dim>> &velocities) const
  {
    // Those of walls at rest, too: what had to slide along one and sticks to it now must stop.
    for (const LocalNode node : constraints.indices())
    {
      const NodeConstraint<dim> &prescribed = constraints[node];
      for (unsigned int a = 0; a < prescribed.n_fixed; ++a)
        velocities[node] += ((prescribed.velocity - velocities[node]) * prescribed.frame[a]) *
                            prescribed.frame[a];
    }
    for (const auto &[node, i] : numbering.solid_nodes())
      velocities[node] = solid.mean_velocity(i); // the prescribed ones
  }



  template <int dim>
  typename StepState<dim>::Floors StepProblem<dim>::floors(const ParticleCloud<dim> &cloud) const
  {
    double spacing = 0.;
    for (const Vertex v : numbering.own_vertices())
      spacing += cloud.spacing[mesh->particle(v.value())];
    const double mean_spacing = Utilities::MPI::sum(spacing, communicator()) /
                                std::max(1U, Utilities::MPI::sum(numbering.n_own_vertices(), communicator()));
    // At rest there is nothing to compare with but what gravity does in a step, and the speed of sound. In free fall there
    // is no pressure: what counts is one that accelerates a cell to the fluid's speed within the step.
    return {(negligible_acceleration * fluid.state.gravity.norm() * fluid.state.time_step +
             negligible_sound * solid.speed_of_sound() +
             (materials.any_exact_yield_stress() ? standing_velocity : 0.)) *
                std::sqrt(static_cast<double>(system.n_nodes())) +
              1e-300,
            negligible_acceleration * materials.largest_density() * mean_spacing / fluid.state.time_step};
  }



  template <int dim>
  IndexVector<LocalNode, Point<dim>> StepProblem<dim>::reinit_system(const ParticleCloud<dim> &cloud,
                                                                     const Migration<dim> &migration)
  {
    IndexVector<RegionNode, Point<dim>> positions(region_mesh->n_vertices() + solid.n_own_nodes());
    solid.get_positions(positions);
    for (unsigned int v = 0; v < region_mesh->n_vertices(); ++v)
      positions[RegionNode(v)] = cloud.position[region_mesh->particle(v)];
    const bool is_alone                      = migration.is_alone();
    const std::vector<unsigned int> contacts = contact.cells(solid.nodes());
    if (const auto now = std::make_tuple(region_mesh->connectivity_number(), solid.nodes(), contacts);
        !is_alone || now != numbered)
    {
      TimerOutput::Scope scope(timer, "Set up system");
      numbered = now;
      system.reinit(region_mesh->n_vertices(), region_mesh->cells(),
                    {solid.n_own_nodes(), solid.cells(), solid.nodes_per_cell(), contacts}, positions,
                    is_alone ? NodeIdentities() : identify_nodes(cloud, migration, positions));
      solution = system.make_vector();
    }
    else
      system.set_positions(positions);

    numbering.reinit(system.partition(), region_mesh->n_vertices(), solid.nodes());
    IndexVector<LocalNode, Point<dim>> known_positions;
    for (const LocalNode node : numbering.nodes())
      known_positions.push_back(positions[numbering.region_node(node)]);
    mesh = region_mesh;
    if (is_alone)
      return known_positions;
    std::vector<unsigned int> vertices;
    for (const Vertex v : numbering.vertices())
      vertices.push_back(numbering.region_vertex(v).value());
    part.reinit_part(*region_mesh, vertices, system.cells());
    mesh = &part;
    return known_positions;
  }



  template <int dim>
  NodeIdentities StepProblem<dim>::identify_nodes(const ParticleCloud<dim> &cloud,
                                                  const Migration<dim> &migration,
                                                  const IndexVector<RegionNode, Point<dim>> &positions) const
  {
    NodeIdentities identities;
    for (const unsigned int i : region_mesh->particles())
    {
      identities.owners.push_back(cloud.owner[i]);
      identities.keys.push_back(cloud.number[i]);
    }
    constexpr std::uint64_t beyond_particles = 1ULL << 60;
    for (RegionNode node(region_mesh->n_vertices()); node.value() < positions.size(); ++node)
    {
      identities.owners.push_back(migration.rank_at(positions[node]));
      identities.keys.push_back(beyond_particles + solid.solid_node(node).value());
    }
    return identities;
  }



  template <int dim>
  void StepProblem<dim>::set_constraints(const Start &start,
                                         const IndexVector<LocalNode, Point<dim>> &positions)
  {
    IndexVector<LocalNode, bool> is_solid(numbering.n_nodes(), false),
      can_be_held(numbering.n_nodes(), false);
    constraints.assign(numbering.n_nodes(), NodeConstraint<dim>());
    for (const Vertex v : numbering.vertices())
    {
      constraints[numbering.node(v)] = start.constraints[numbering.region_vertex(v).value()];
      can_be_held[numbering.node(v)] = start.cloud.kind[mesh->particle(v.value())] == ParticleKind::fluid;
    }
    for (const auto &[node, i] : numbering.solid_nodes())
    {
      constraints[node] = solid.constraint(i);
      is_solid[node]    = true;
    }
    safeguards.start_step({*mesh, system, numbering, materials, is_solid, can_be_held, positions});
    safeguards.fix_pressures(constraints);
    system.set_constraints(constraints);
  }



  template <int dim>
  void StepProblem<dim>::update_by_fluid(std::vector<Tensor<1, dim>> &values) const
  {
    const unsigned int n = mesh->n_vertices();
    for (unsigned int fluid = 0; fluid < materials.n_fluids(); ++fluid)
    {
      const auto begin                                = values.begin() + fluid * n;
      IndexVector<LocalNode, Tensor<1, dim>> of_fluid = numbering.by_node(
        IndexVector<Vertex, Tensor<1, dim>>(std::vector<Tensor<1, dim>>(begin, begin + n)));
      system.partition().update(of_fluid);
      const IndexVector<Vertex, Tensor<1, dim>> updated = numbering.by_vertex(of_fluid);
      std::copy(updated.begin(), updated.end(), begin);
    }
  }



  template void StepProblem<2>::start_step(const Start &);
  template void StepProblem<3>::start_step(const Start &);
} // namespace Lahar
