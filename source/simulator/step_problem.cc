#include <lahar/simulator/step_problem.h>
#include <lahar/simulator/undetermined_pressures.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Increments that would invert simplices even at this part of their length are not taken.
    constexpr double shortest_step = 1e-3;
  } // namespace



  template <int dim>
  StepProblem<dim>::StepProblem(const MPI_Comm &communicator, TimerOutput &timer)
    : communicator(communicator)
    , timer(timer)
    , system(communicator)
  {}



  template <int dim>
  void StepProblem<dim>::declare_parameters(Parameters &prm)
  {
    FluidAssembler<dim>::declare_parameters(prm);
    LinearSolver<dim>::declare_parameters(prm);
  }



  template <int dim>
  void StepProblem<dim>::parse_parameters(Parameters &prm)
  {
    assembler.parse_parameters(prm);
    linear_solver = LinearSolver<dim>::create(prm);
  }



  template <int dim>
  void StepProblem<dim>::start_step(const FluidMesh<dim> &new_mesh, const ParticleCloud<dim> &cloud,
                                    const std::vector<NodeConstraint<dim>> &vertex_constraints,
                                    const FluidLaw &law, const Tensor<1, dim> &new_gravity,
                                    const TimeIntegration &integration, const std::vector<bool> &arrives,
                                    const Solids<dim> &solids, const double end_time)
  {
    mesh             = &new_mesh;
    fluid_law        = &law;
    gravity          = new_gravity;
    time_integration = integration;

    TimeIntegration solid_integration = time_integration.with_gamma(solids.newmark_gamma());
    solid.start(solids, *mesh, solid_integration, end_time);
    constraints = vertex_constraints;
    solid.add_constraints(constraints);
    fix_undetermined_pressures(mesh->cells(), constraints);
    reinit_system(cloud);
    linear_solver->forget();

    fluid.start(*mesh, cloud, time_integration, arrives);
    velocity_change.assign(system.n_nodes(), Tensor<1, dim>());
    std::vector<bool> is_fluid(mesh->n_vertices());
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
      is_fluid[v] = cloud.kind[mesh->particle(v)] == ParticleKind::fluid;
    held_vertices.start_step(is_fluid);
    pressure_change.assign(mesh->n_vertices(), 0.);

    assembler.set_stabilization(*mesh, law, gravity, fluid.state);
    if (law.yield_stress() > 0.)
      assembler.start_plastic_dual(*mesh, law, fluid.state);
    std::vector<Tensor<1, dim>> velocities = node_velocities();
    solid.get_velocities(velocities); // the prescribed ones
    set_node_velocities(velocities);
    // Where the old velocities would flatten simplices, let their vertices move less; if they do not move at all,
    // nothing is. Walls and solids keep their velocities; a driven solid may leave no room.
    std::vector<double> motion(mesh->n_vertices(), 1.);
    const std::vector<double> old_volumes = fluid.old_volumes();
    for (bool any_shorter = true; any_shorter;)
    {
      any_shorter = false;
      for (const unsigned int v : fluid.shrinking_vertices(old_volumes))
        if (constraints[v].n_fixed < dim && motion[v] > 0.)
        {
          any_shorter   = true;
          motion[v]     = std::max(0., motion[v] - 0.25);
          velocities[v] = fluid.slowed_velocity(v, motion[v]);
        }
      if (any_shorter)
        set_node_velocities(velocities);
    }
    set_norms();
  }



  template <int dim>
  void StepProblem<dim>::reinit_system(const ParticleCloud<dim> &cloud)
  {
    std::vector<Point<dim>> positions(mesh->n_vertices() + solid.n_own_nodes());
    solid.get_positions(positions);
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
      positions[v] = cloud.position[mesh->particle(v)];
    if (mesh->cells() != numbered_cells || solid.nodes() != numbered_solid_nodes)
    {
      TimerOutput::Scope scope(timer, "Set up system");
      numbered_cells       = mesh->cells();
      numbered_solid_nodes = solid.nodes();
      system.reinit(mesh->n_vertices(), numbered_cells, solid.n_own_nodes(), solid.cells(),
                    solid.nodes_per_cell(), positions);
      solution = system.make_vector();
    }
    else
      system.set_positions(positions);
    system.set_constraints(constraints);
  }



  template <int dim>
  std::vector<Tensor<1, dim>> StepProblem<dim>::node_velocities() const
  {
    std::vector<Tensor<1, dim>> velocities(system.n_nodes());
    solid.get_velocities(velocities);
    fluid.get_velocities(velocities);
    return velocities;
  }



  template <int dim>
  void StepProblem<dim>::set_node_velocities(const std::vector<Tensor<1, dim>> &velocities)
  {
    fluid.move(velocities);
    solid.move(velocities);
  }



  template <int dim>
  void StepProblem<dim>::set_norms()
  {
    double v = 0., p = 0., dv = 0., dp = 0.;
    for (const Tensor<1, dim> &velocity : node_velocities())
      v += velocity.norm_square();
    for (unsigned int i = 0; i < system.n_nodes(); ++i)
      dv += velocity_change[i].norm_square();
    for (unsigned int i = 0; i < mesh->n_vertices(); ++i)
    {
      p += fluid.state.pressure[i] * fluid.state.pressure[i];
      dp += pressure_change[i] * pressure_change[i];
    }
    // At rest there is nothing to compare with but what gravity does in a step, and the speed of sound.
    const double n_nodes = system.n_nodes();
    const double v_floor = (1e-8 * gravity.norm() * fluid.state.factors.time_step +
                            1e-8 * solid.speed_of_sound()) *
                             std::sqrt(n_nodes) +
                           1e-300;
    const double p_floor = v_floor * fluid_law->density() * (1. + std::sqrt(v / n_nodes));
    velocity_norm        = std::max(std::sqrt(v), v_floor);
    pressure_norm        = std::max(std::sqrt(p), p_floor);

    relative_velocity_increment = std::sqrt(dv) / velocity_norm;
    relative_pressure_increment = std::sqrt(dp) / pressure_norm;
  }



  template <int dim>
  bool StepProblem<dim>::on_all_ranks(const bool fine) const
  {
    return Utilities::MPI::min(fine ? 1U : 0U, communicator) == 1U;
  }



  template <int dim>
  void StepProblem<dim>::assemble(const Linearization &linearization)
  {
    {
      TimerOutput::Scope scope(timer, "Assemble");
      if (!on_all_ranks(assembler.assemble(*mesh, *fluid_law, gravity, fluid.state, linearization, system)))
        throw RunError("a simplex is inverted");
    }
    if (solid.nodes_per_cell() > 0)
    {
      TimerOutput::Scope scope(timer, "Assemble solids");
      if (!on_all_ranks(solid.assemble(gravity, system)))
        throw RunError("an element of a solid is inverted");
    }
    if (!std::isfinite(momentum_residual_norm()) || !std::isfinite(mass_residual_norm()))
      throw RunError("the residual is not a finite number");
  }



  template <int dim>
  unsigned int StepProblem<dim>::solve(const double negligible)
  {
    TimerOutput::Scope scope(timer, "Solve");
    // The size of an increment against which its error counts; before there is any flow, what it will be.
    const double length  = std::sqrt(static_cast<double>(system.n_nodes()));
    const double v_scale = std::max(velocity_norm,
                                    gravity.norm() * fluid.state.factors.time_step * length * 1e-3);
    const double p_scale = std::max(pressure_norm, fluid_law->density() * v_scale * v_scale / length);
    const unsigned int n_iterations = linear_solver->solve(system, {v_scale, p_scale, negligible}, solution);
    start_increment();
    return n_iterations;
  }



  template <int dim>
  unsigned int StepProblem<dim>::solve_block(const unsigned int b)
  {
    TimerOutput::Scope scope(timer, "Solve");
    solution                        = 0.;
    const unsigned int n_iterations = linear_solver->solve_block(system, b, solution);
    start_increment();
    return n_iterations;
  }



  template <int dim>
  void StepProblem<dim>::start_increment()
  {
    velocity_change = system.velocities(solution);
    pressure_change = system.pressures(solution);
    if (!std::isfinite(solution.l2_norm()))
      throw RunError("the solution of the linear system is not a finite number");
    base_velocity = node_velocities();
    base_volumes  = fluid.new_volumes();
    base_pressure = fluid.state.pressure;
    if (fluid_law->yield_stress() > 0.)
      assembler.predict_plastic_dual(*mesh, *fluid_law, fluid.state, velocity_change, base_dual, dual_change);
  }



  template <int dim>
  void StepProblem<dim>::take_step(const double length)
  {
    TimerOutput::Scope scope(timer, "Update");
    std::vector<double> lengths(system.n_nodes(), length);
    std::vector<Tensor<1, dim>> velocities(system.n_nodes());
    const auto move_along = [&] {
      for (unsigned int v = 0; v < system.n_nodes(); ++v)
        velocities[v] = base_velocity[v] + lengths[v] * velocity_change[v];
      set_node_velocities(velocities);
    };
    damped = false;
    for (bool any_shorter = true; any_shorter;)
    {
      move_along();
      any_shorter = false;
      for (const unsigned int v : fluid.shrinking_vertices(base_volumes))
        if (lengths[v] > 0.)
        {
          any_shorter = damped = true;
          lengths[v]           = (lengths[v] > shortest_step * length ? 0.5 * lengths[v] : 0.);
        }
    }
    if (length == 1.)
      held_vertices.note(lengths);
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
      fluid.state.pressure[v] = base_pressure[v] + length * pressure_change[v];
    if (fluid_law->yield_stress() > 0.)
      for (unsigned int c = 0; c < mesh->n_cells(); ++c)
        fluid.state.plastic_dual[c] = base_dual[c] + length * dual_change[c];
    set_norms();
    if (!std::isfinite(velocity_norm) || !std::isfinite(pressure_norm))
      throw RunError("velocity or pressure is not a finite number");
  }



  template <int dim>
  void StepProblem<dim>::hold_blocked_vertices()
  {
    if (held_vertices.update(constraints))
    {
      fix_undetermined_pressures(mesh->cells(), constraints);
      system.set_constraints(constraints);
    }
  }



  template <int dim>
  Vector<double> StepProblem<dim>::unknowns() const
  {
    const unsigned int n = system.n_nodes();
    Vector<double> values(dim * n + mesh->n_vertices());
    const std::vector<Tensor<1, dim>> velocities = node_velocities();
    for (unsigned int v = 0; v < n; ++v)
      for (unsigned int d = 0; d < dim; ++d)
        values[dim * v + d] = velocities[v][d];
    std::copy(fluid.state.pressure.begin(), fluid.state.pressure.end(), values.begin() + dim * n);
    return values;
  }



  template <int dim>
  Vector<double> StepProblem<dim>::unknown_weights() const
  {
    const unsigned int n = system.n_nodes();
    Vector<double> weights(dim * n + mesh->n_vertices());
    for (unsigned int i = 0; i < weights.size(); ++i)
      weights[i] = 1. / (i < dim * n ? velocity_norm : pressure_norm);
    return weights;
  }



  template <int dim>
  bool StepProblem<dim>::set_unknowns(const Vector<double> &values)
  {
    const unsigned int n      = system.n_nodes();
    const auto old_velocities = node_velocities();
    std::vector<Tensor<1, dim>> velocities(n);
    for (unsigned int v = 0; v < n; ++v)
      for (unsigned int d = 0; d < dim; ++d)
        velocities[v][d] = values[dim * v + d];
    set_node_velocities(velocities);
    const bool inverted = !fluid.shrinking_vertices(base_volumes).empty();
    if (inverted)
      set_node_velocities(old_velocities);
    else
      std::copy(values.begin() + dim * n, values.end(), fluid.state.pressure.begin());
    set_norms();
    return !inverted;
  }



  template <int dim>
  Point<dim> StepProblem<dim>::place_of_largest_increment() const
  {
    unsigned int place = 0;
    double largest     = -1.;
    std::vector<Point<dim>> positions(system.n_nodes());
    solid.get_positions(positions);
    std::copy(fluid.state.position.begin(), fluid.state.position.end(), positions.begin());
    for (unsigned int v = 0; v < system.n_nodes(); ++v)
    {
      const double increment = velocity_change[v].norm() / velocity_norm +
                               (v < mesh->n_vertices() ? std::abs(pressure_change[v]) / pressure_norm : 0.);
      if (increment > largest)
      {
        largest = increment;
        place   = v;
      }
    }
    return positions[place];
  }



  template <int dim>
  std::vector<Tensor<1, dim>> StepProblem<dim>::solid_reactions() const
  {
    const std::vector<Tensor<1, dim>> residual = system.solid_residual();
    std::vector<Tensor<1, dim>> reactions;
    for (const unsigned int node : solid.nodes())
      reactions.push_back(residual[node]);
    return reactions;
  }



  template <int dim>
  void StepProblem<dim>::accept(ParticleCloud<dim> &cloud, Solids<dim> &solids)
  {
    solid.accept(solids);
    fluid.accept(cloud);
    linear_solver->forget(); // remeshing and output need the memory
  }



  template class StepProblem<2>;
  template class StepProblem<3>;
} // namespace Lahar
