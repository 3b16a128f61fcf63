// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/step_problem.h>
#include <lahar/utilities/ranks.h>
#include <lahar/utilities/true_on_all_ranks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Lahar
{
  template <int dim>
  StepProblem<dim>::StepProblem(const MPI_Comm &communicator, TimerOutput &timer)
    : timer(timer)
    , system(communicator)
  {}



  template <int dim>
  void StepProblem<dim>::declare_parameters(Parameters &prm)
  {
    TimeIntegration::declare_parameters(prm);
    FluidAssembler<dim>::declare_parameters(prm);
    LinearSolver<dim>::declare_parameters(prm);
    prm.enter_subsection("Nonlinear solver");
    prm.declare_positive(
      "Standing velocity", "1e-7",
      "Speed in m/s, above zero, below which fluid with an exact yield stress stands: where all of a connected part "
      "is slower than this and 1e-4 of what gravity makes in a step together the pressures that carry it are kept, and "
      "smaller velocities count as errors of this one.");
    prm.leave_subsection();
  }



  template <int dim>
  void StepProblem<dim>::parse_parameters(Parameters &prm)
  {
    integration.parse_parameters(prm);
    assembler.parse_parameters(prm);
    linear_solver = LinearSolver<dim>::create(prm);
    prm.enter_subsection("Nonlinear solver");
    standing_velocity = prm.get_positive("Standing velocity");
    prm.leave_subsection();
  }



  template <int dim>
  IndexVector<LocalNode, Tensor<1, dim>> StepProblem<dim>::fluid_velocities() const
  {
    return numbering.by_node(IndexVector<Vertex, Tensor<1, dim>>(fluid.state.mean_velocity));
  }



  template <int dim>
  IndexVector<LocalNode, double> StepProblem<dim>::fluid_pressures() const
  {
    return numbering.by_node(IndexVector<Vertex, double>(fluid.state.pressure));
  }



  template <int dim>
  IndexVector<LocalNode, Tensor<1, dim>> StepProblem<dim>::node_velocities() const
  {
    IndexVector<LocalNode, Tensor<1, dim>> velocities = fluid_velocities();
    for (const auto &[node, i] : numbering.solid_nodes())
      if (!numbering.is_vertex(node))
        velocities[node] = solid.mean_velocity(i);
    return velocities;
  }



  template <int dim>
  IndexVector<SolidNode, Tensor<1, dim>>
  StepProblem<dim>::of_solids(const IndexVector<LocalNode, Tensor<1, dim>> &values) const
  {
    return solid.gather(numbering, communicator(), values);
  }



  template <int dim>
  void StepProblem<dim>::set_norms()
  {
    step_state.set_norms(node_velocities(), fluid.state, numbering, communicator());
  }



  template <int dim>
  void StepProblem<dim>::assemble(const Linearization &linearization)
  {
    {
      TimerOutput::Scope scope(timer, "Assemble");
      if (!true_on_all_ranks(assembler.assemble(*mesh, materials, fluid.state, linearization, system),
                             communicator()))
        throw_inverted();
    }
    if (friction.any())
      friction.assemble(fluid_velocities(), fluid_pressures(), contact, system);
    contact.assemble(system);
    if (solid.nodes_per_cell() > 0)
    {
      TimerOutput::Scope scope(timer, "Assemble solids");
      if (!true_on_all_ranks(solid.assemble(fluid.state.gravity, system), communicator()))
        throw RunError("an element of a solid is inverted");
    }
    if (!std::isfinite(momentum_residual_norm()) || !std::isfinite(mass_residual_norm()))
      throw RunError("the residual is not a finite number");
  }



  template <int dim>
  unsigned int StepProblem<dim>::solve(const double negligible, const bool in_two_steps)
  {
    TimerOutput::Scope scope(timer, "Solve");
    step_state.drop_dual();
    // The size of an increment against which its error counts; before there is any flow, what it will be.
    const double length             = std::sqrt(static_cast<double>(system.n_nodes()));
    const double v_scale            = std::max(step_state.velocity_norm(),
                                               fluid.state.gravity.norm() * fluid.state.time_step * length * 1e-3);
    const double p_scale            = std::max(step_state.pressure_norm(),
                                               materials.largest_density() * v_scale * v_scale / length);
    const IncrementScales scales    = {v_scale, p_scale, negligible, materials.any_exact_yield_stress()};
    const unsigned int n_iterations = in_two_steps
                                        ? linear_solver->solve_in_two_steps(system, scales, solution)
                                        : linear_solver->solve(system, scales, solution);
    start_iteration();
    return n_iterations;
  }



  template <int dim>
  void StepProblem<dim>::start_iteration()
  {
    if (!std::isfinite(solution.l2_norm()))
      throw RunError("the solution of the linear system is not a finite number");
    IndexVector<LocalNode, Tensor<1, dim>> velocities = system.velocities(solution);
    IndexVector<Vertex, double> pressures             = system.pressures(solution);
    step_state.start_iteration(node_velocities(), fluid.state, fluid.new_volumes(), std::move(velocities),
                               std::move(pressures));
    if (!materials.any_yields())
      return;
    std::vector<SymmetricTensor<2, dim>> base, change;
    assembler.predict_plastic_dual(*mesh, materials, fluid.state,
                                   numbering.by_vertex(step_state.velocity_change()).raw(), base, change);
    step_state.start_dual(std::move(base), std::move(change));
  }



  template <int dim>
  void StepProblem<dim>::take_step(const double length)
  {
    TimerOutput::Scope scope(timer, "Update");
    const IndexVector<LocalNode, Tensor<1, dim>> velocities = safeguards.advance(step_state, length,
                                                                                 constraints, fluid);
    move_solids(velocities);
    step_state.advance(length, fluid.state);
    set_norms();
    if (!std::isfinite(step_state.velocity_norm()) || !std::isfinite(step_state.pressure_norm()))
      throw RunError("velocity or pressure is not a finite number");
  }



  template <int dim>
  void StepProblem<dim>::move_solids(const IndexVector<LocalNode, Tensor<1, dim>> &velocities)
  {
    solid.move(of_solids(velocities));
    contact.move(fluid, solid);
    friction.move(contact);
  }



  template <int dim>
  void StepProblem<dim>::iterate_friction()
  {
    if (!friction.any())
      return;
    IndexVector<LocalNode, Tensor<1, dim>> reactions = system.momentum_residual();
    system.partition().update(reactions);
    friction.iterate(fluid_velocities(), fluid_pressures(), reactions);
  }



  template <int dim>
  bool StepProblem<dim>::is_settled() const
  {
    return !friction.any() || true_on_all_ranks(friction.is_settled(), communicator());
  }



  template <int dim>
  void StepProblem<dim>::end_iteration()
  {
    iterate_friction();
    contact.iterate();
    if (safeguards.end_iteration(fluid, constraints))
      system.set_constraints(constraints);
  }



  template <int dim>
  void StepProblem<dim>::check_closed_parts() const
  {
    safeguards.check_closed_parts(fluid);
  }



  template <int dim>
  void StepProblem<dim>::throw_inverted() const
  {
    double lowest = 0.;
    Point<dim> place;
    const std::vector<double> volumes = fluid.new_volumes();
    for (unsigned int c = 0; c < volumes.size(); ++c)
      if (!fluid.state.left_out[c] && !fluid.state.sliver[c] && volumes[c] < lowest)
      {
        lowest = volumes[c];
        place  = centroid<dim>(corners_of<dim>(mesh->cells()[c], fluid.state.position));
      }
    std::ostringstream message;
    message << "a simplex is inverted at (" << largest_of_all(-lowest, place, communicator()).second << ") m";
    throw RunError(message.str());
  }



  template <int dim>
  Point<dim> StepProblem<dim>::place_of_largest_increment() const
  {
    const IndexVector<Vertex, Point<dim>> of_fluid(fluid.state.position);
    IndexVector<LocalNode, Point<dim>> positions   = numbering.by_node(of_fluid);
    const IndexVector<LocalNode, double> pressures = numbering.by_node(step_state.pressure_change());
    for (const auto &[node, i] : numbering.solid_nodes())
      positions[node] = solid.position(i);
    LocalNode place(0);
    double largest = -1.;
    for (const LocalNode l : numbering.own_nodes())
    {
      const double increment = step_state.increment_at(l, pressures[l]);
      if (increment > largest)
      {
        largest = increment;
        place   = l;
      }
    }
    return largest_of_all(largest, positions.empty() ? Point<dim>() : positions[place], communicator())
      .second;
  }



  template <int dim>
  std::pair<double, Point<dim>> StepProblem<dim>::largest_movement(const ParticleCloud<dim> &cloud) const
  {
    double largest = 0.;
    Point<dim> place;
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      const double movement = fluid.state.position[v].distance(fluid.state.old_position[v]) /
                              cloud.spacing[mesh->particle(v)];
      if (movement > largest)
      {
        largest = movement;
        place   = fluid.state.old_position[v];
      }
    }
    return largest_of_all(largest, place, communicator());
  }



  template <int dim>
  typename StepProblem<dim>::Reactions StepProblem<dim>::reactions() const
  {
    Reactions result;
    IndexVector<LocalNode, Tensor<1, dim>> residuals = system.momentum_residual();
    if (contact.any())
    {
      const auto along = friction.forces_on_solids(fluid_velocities(), fluid_pressures(), contact);
      IndexVector<LocalNode, unsigned int> n_contacts(residuals.size(), 0);
      for (unsigned int k = 0; k < contact.n_contacts(); ++k)
        ++n_contacts[numbering.node(RegionVertex(contact.touch(k).vertex))];
      std::vector<double> on_fluid(dim * solid.nodes().size(), 0.);
      for (unsigned int k = 0; k < contact.n_contacts(); ++k)
        if (const LocalNode node = numbering.node(RegionVertex(contact.touch(k).vertex));
            numbering.is_own(node))
        {
          // Where nothing else holds the vertex the force is all that the fluid exerts there, exact as that of a wall is.
          const bool is_alone           = n_contacts[node] == 1 && constraints[node].n_fixed == 0;
          const Tensor<1, dim> on_solid = is_alone ? -residuals[node] : contact.normal_force(k) + along[k];
          if (!is_alone)
            residuals[node] += on_solid;
          for (unsigned int v = 0; v < dim; ++v)
            for (unsigned int a = 0; a < dim; ++a)
              on_fluid[dim * contact.touch(k).corners[v] + a] += contact.weights(k)[v + 1] * on_solid[a];
        }
      Utilities::MPI::sum(on_fluid, communicator(), on_fluid);
      for (unsigned int i = 0; i < solid.nodes().size(); ++i)
        result.of_slick_solids.emplace_back(make_array_view(&on_fluid[dim * i], &on_fluid[dim * i] + dim));
    }
    system.partition().update(residuals);
    IndexVector<RegionVertex, Tensor<1, dim>> at_vertices(region_mesh->n_vertices());
    for (const Vertex v : numbering.vertices())
      at_vertices[numbering.region_vertex(v)] = residuals[numbering.node(v)];
    result.at_vertices = std::move(at_vertices.raw());
    return result;
  }



  template <int dim>
  std::vector<unsigned int> StepProblem<dim>::left_out_cells() const
  {
    std::vector<unsigned int> cells;
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      if (fluid.state.left_out[c])
        cells.push_back(system.cells()[c]);
    return cells;
  }



  template <int dim>
  void StepProblem<dim>::accept(ParticleCloud<dim> &cloud, Solids<dim> &solids)
  {
    solid.accept(of_solids(system.solid_residual()), solids);
    friction.accept(fluid_velocities(), fluid_pressures(), *region_mesh, cloud);
    fluid.accept(cloud);
    linear_solver->forget(); // remeshing and output need the memory
  }



  template class StepProblem<2>;
  template class StepProblem<3>;
} // namespace Lahar
