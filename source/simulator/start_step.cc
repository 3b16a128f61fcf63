#include <lahar/simulator/step_problem.h>
#include <lahar/simulator/undetermined_pressures.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void StepProblem<dim>::start_step(const FluidMesh<dim> &new_mesh, const ParticleCloud<dim> &cloud,
                                    const std::vector<NodeConstraint<dim>> &vertex_constraints,
                                    const FluidLaw &law, const Tensor<1, dim> &new_gravity,
                                    const TimeIntegration &integration, const std::vector<bool> &arrives,
                                    const Solids<dim> &solids, const double end_time)
  {
    whole_mesh       = &new_mesh;
    fluid_law        = &law;
    gravity          = new_gravity;
    time_integration = integration;
    arriving         = arrives;
    solid.start(solids, *whole_mesh, time_integration.with_gamma(solids.newmark_gamma()), end_time);
    reinit_system(cloud);
    set_constraints(vertex_constraints);
    linear_solver->forget();

    // Arrays over all vertices are by vertex of the whole mesh, of which this rank takes what it knows.
    std::vector<bool> arrives_here, can_be_held(constraints.size(), false);
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      const unsigned int node = system.local_number(v);
      arrives_here.push_back(arrives[system.partition().nodes()[node]]);
      can_be_held[node] = cloud.kind[mesh->particle(v)] == ParticleKind::fluid;
    }
    fluid.start(*mesh, cloud, time_integration, arrives_here);
    held_vertices.start_step(can_be_held);
    crushed_cells.start_step(mesh->n_cells());
    velocity_change.assign(constraints.size(), Tensor<1, dim>());
    pressure_change.assign(mesh->n_vertices(), 0.);

    assembler.set_stabilization(*mesh, law, gravity, fluid.state);
    update_vertices(fluid.state.residual_projection);
    if (law.yield_stress() > 0.)
      assembler.start_plastic_dual(*mesh, law, fluid.state);
    std::vector<Tensor<1, dim>> velocities = node_velocities();
    for (const auto &[node, i] : solid.known_nodes(system.partition()))
      velocities[node] = solid.velocity(i); // the prescribed ones
    slow_down(velocities);
    solid.move(solid.gather(system.partition(), velocities));
    set_norms();
  }



  template <int dim>
  void StepProblem<dim>::slow_down(std::vector<Tensor<1, dim>> &velocities)
  {
    // The vertices of flattened simplices move less; if they do not move at all, nothing is flattened. Walls and solids
    // keep their velocities; a driven solid may leave no room.
    fluid.move(by_vertex(velocities));
    std::vector<double> motion(constraints.size(), 1.);
    const std::vector<double> old_volumes = fluid.old_volumes();
    for (bool any_shorter = true; any_shorter;)
    {
      any_shorter = false;
      for (const unsigned int v : fluid.shrinking_vertices(old_volumes))
      {
        const unsigned int node = system.local_number(v);
        if (constraints[node].n_fixed < dim && motion[node] > 0.)
        {
          any_shorter  = true;
          motion[node] = std::max(0., motion[node] - 0.25);
        }
      }
      any_shorter = !on_all_ranks(!any_shorter);
      if (!any_shorter)
        break;
      system.partition().update(motion);
      for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
        if (motion[system.local_number(v)] < 1.)
          velocities[system.local_number(v)] = fluid.slowed_velocity(v, motion[system.local_number(v)]);
      fluid.move(by_vertex(velocities));
    }
  }



  template <int dim>
  void StepProblem<dim>::reinit_system(const ParticleCloud<dim> &cloud)
  {
    std::vector<Point<dim>> positions(whole_mesh->n_vertices() + solid.n_own_nodes());
    solid.get_positions(positions);
    for (unsigned int v = 0; v < whole_mesh->n_vertices(); ++v)
      positions[v] = cloud.position[whole_mesh->particle(v)];
    if (whole_mesh->connectivity_number() != connectivity_number || solid.nodes() != numbered_solid_nodes)
    {
      TimerOutput::Scope scope(timer, "Set up system");
      connectivity_number  = whole_mesh->connectivity_number();
      numbered_solid_nodes = solid.nodes();
      system.reinit(whole_mesh->n_vertices(), whole_mesh->cells(), solid.n_own_nodes(), solid.cells(),
                    solid.nodes_per_cell(), positions);
      solution = system.make_vector();
    }
    else
      system.set_positions(positions);

    mesh = whole_mesh;
    if (Utilities::MPI::n_mpi_processes(communicator()) == 1)
      return;
    std::vector<unsigned int> vertices;
    for (const unsigned int node : system.partition().nodes())
      if (node < system.n_fluid_nodes())
        vertices.push_back(node);
    part.reinit_part(*whole_mesh, vertices, system.cells());
    mesh = &part;
  }



  template <int dim>
  void StepProblem<dim>::set_constraints(const std::vector<NodeConstraint<dim>> &vertex_constraints)
  {
    is_solid.assign(system.partition().nodes().size(), false);
    constraints.clear();
    for (const unsigned int node : system.partition().nodes())
      constraints.push_back(node < vertex_constraints.size() ? vertex_constraints[node]
                                                             : NodeConstraint<dim>());
    for (const auto &[node, i] : solid.known_nodes(system.partition()))
    {
      constraints[node] = solid.constraint(i);
      is_solid[node]    = true;
    }
    fix_undetermined_pressures(system.cells_by_local_number(), system.partition(), constraints);
    system.set_constraints(constraints);
  }



  template void StepProblem<2>::start_step(const FluidMesh<2> &, const ParticleCloud<2> &,
                                           const std::vector<NodeConstraint<2>> &, const FluidLaw &,
                                           const Tensor<1, 2> &, const TimeIntegration &,
                                           const std::vector<bool> &, const Solids<2> &, const double);
  template void StepProblem<3>::start_step(const FluidMesh<3> &, const ParticleCloud<3> &,
                                           const std::vector<NodeConstraint<3>> &, const FluidLaw &,
                                           const Tensor<1, 3> &, const TimeIntegration &,
                                           const std::vector<bool> &, const Solids<3> &, const double);
} // namespace Lahar
