// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_structure.h>
#include <lahar/boundary/solid_touch.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/remeshing/interface_correction.h>
#include <lahar/simulator/simulator.h>
#include <lahar/utilities/ranks.h>
#include <lahar/utilities/stop_signal.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

namespace Lahar
{
  template <int dim>
  void Simulator<dim>::declare_parameters(Parameters &prm, const CaseStructure &structure)
  {
    Case<dim>::declare_parameters(prm, structure);
    TimeIntegration::declare_parameters(prm);
    Solids<dim>::declare_parameters(prm, structure.solids);
    Remesher<dim>::declare_parameters(prm);
    NonlinearScheme<dim>::declare_parameters(prm);
    StepProblem<dim>::declare_parameters(prm);
    Postprocessor<dim>::declare_all(prm);
    OutputField<dim>::declare_all(prm);
  }



  template <int dim>
  Simulator<dim>::Simulator(Parameters &prm, const CaseStructure &structure, const MPI_Comm &communicator)
    : prm(prm)
    , migration(communicator)
    , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
    , problem(communicator, timer)
    , output(input.run, prm, communicator)
    , checkpoint(input.run, prm, communicator)
  {
    solids.parse_parameters(prm, structure.solids);
    input.parse_parameters(prm, structure);
    materials = input.geometry.materials();
    time_integration.parse_parameters(prm);
    remesher.parse_parameters(prm);
    remesher.set_number_of_fluids(materials.n_fluids());
    scheme       = NonlinearScheme<dim>::create(prm);
    step_control = std::make_unique<StepControl>(input.run.time_step, input.run.minimum_time_step,
                                                 input.run.maximum_time_step, scheme->max_iterations());
    problem.parse_parameters(prm);
    if (materials.any_exact_yield_stress() && !problem.projects_residual())
    {
      prm.enter_subsection("Stabilization");
      prm.throw_wrong_value("Form",
                            "'projected residual' for a fluid whose 'Yield' is 'exact': with another form it "
                            "would creep by the stabilisation however large its yield stress is");
    }
    output.parse_parameters();
  }



  template <int dim>
  void Simulator<dim>::check_ranks() const
  {
    if (Utilities::MPI::n_mpi_processes(communicator()) == 1)
      return;
    const SolidState<dim> &state = solids.state();
    boost::crc_32_type sum;
    sum.process_bytes(&time, sizeof(time));
    sum.process_bytes(state.position.data(), state.position.size() * sizeof(Point<dim>));
    sum.process_bytes(state.velocity.data(), state.velocity.size() * sizeof(Tensor<1, dim>));
    const auto range = Utilities::MPI::min_max_avg(static_cast<double>(sum.checksum()), communicator());
    if (range.min != range.max)
      throw RunError("Time " + std::to_string(time) +
                     " s: the ranks' solids differ. Do all ranks run the same program on the same kind of "
                     "processor?");
  }



  template <int dim>
  double Simulator<dim>::region_distance() const
  {
    return remesher.region_distance(particles, fluid_mesh, solids.longest_edge(), communicator());
  }



  template <int dim>
  void Simulator<dim>::migrate()
  {
    migration.migrate(particles, fluid_mesh, region_distance(), solids.mesh().n_contour_nodes(),
                      has_multipliers() ? &multipliers.table() : nullptr);
  }



  template <int dim>
  double Simulator<dim>::sum_of_ranks(const double value) const
  {
    return Utilities::MPI::sum(value, communicator());
  }



  template <int dim>
  unsigned int Simulator<dim>::count_on_ranks(const unsigned int n) const
  {
    return Utilities::MPI::sum(n, communicator());
  }



  template <int dim>
  void Simulator<dim>::step(double time_step)
  {
    check_ranks();
    if (counters.steps > 0 && input.geometry.has_fluid())
      remesh(time_step);

    NonlinearReport report;
    std::optional<WallStep<dim>> wall_step;
    for (bool accepted = false; !accepted;)
      try
      {
        time_integration.start_step(time_step, counters.steps == 0);
        wall_step.emplace(input.geometry.wall_step(walls, time, time_step));
        // Where the slick solids will be at the end is not known yet.
        const WallStep<dim> contact_step = with_slick_solids(*wall_step, particles.position, time_step);
        inlets.start_step(particles, fluid_mesh, communicator(), time, time_step);
        problem.start_step({fluid_mesh, particles, solids, migration, materials, input.gravity,
                            time_integration, time + time_step, constraints(contact_step), remeshing.arrives,
                            SlidingContact<dim>::find(fluid_mesh, particles, contact_step, surface_laws()),
                            SolidTouch<dim>::find(fluid_mesh, particles, contact_step, slick_facets()),
                            multipliers.values(),
                            FluidStructure<dim>::of_cells(fluid_mesh, materials, particles), outlets});
        report = scheme->solve(problem, [this] {
          if (StopSignal::received(communicator()) != 0)
            throw StopRequest();
        });
        problem.check_closed_parts();
        check_movements();
        accepted = true;
      }
      catch (const RunError &error)
      {
        std::ostringstream message;
        message << "Time " << time + time_step << " s (step of " << time_step << " s), " << error.what();
        if (!step_control->halve(time_step))
        {
          output.write_snapshot(snapshot());
          write_kept_state();
          throw RunError(message.str() +
                         "; the last snapshot and the checkpoint show the state before this step");
        }
        output.message(message.str() + "; repeated with half the step");
        ++counters.rejected;
      }
    step_control->accept(report.iterations);

    const std::vector<Point<dim>> old_position = solids.state().position;
    move_particles(time_step, *wall_step);
    if (wall_step->any_moves())
      walls = Walls<dim>(wall_step->end());
    time += time_step;
    ++counters.steps;
    TimerOutput::Scope scope(timer, "Output");
    add_statistics(time_step, report);
    stop_at_collision(old_position, *wall_step);
  }



  template <int dim>
  void Simulator<dim>::remesh(const double time_step)
  {
    TimerOutput::Scope scope(timer, "Remesh");
    exchange_fluid();
    if (const unsigned int n_dropped = count_on_ranks(input.domain_limit.drop_outside(particles, fluid_mesh)))
    {
      counters.left += n_dropped;
      account.volume.left(fluid_volume());
      account.fluids.left(fluid_volumes());
      account.momentum.set(fluid_momentum());
    }
    migrate();
    const SolidContour<dim> contour(solids.mesh().contour(), particles);
    input.mesh_size.update(particles);
    const std::map<std::uint64_t, double> layers = inlets.layers(particles, fluid_mesh);
    if (has_multipliers())
      multipliers.spread(fluid_mesh, materials.n_fluids(), particles, migration);
    try
    {
      remeshing = remesher.remesh(particles, obstacles(contour), contour.facets_that_land(false), time_step,
                                  fluid_mesh, migration);
    }
    catch (const RunError &error)
    {
      throw RunError("Time " + std::to_string(time) + " s, remeshing: " + error.what() + ".");
    }
    if (has_multipliers())
      multipliers.follow(fluid_mesh, particles);
    FluidStructure<dim>::complete(fluid_mesh, materials, migration, particles);
    if (remesher.keeps_volume())
      inlets.owe_layers(layers, fluid_mesh, migration, particles);
    counters.forced_facets += count_on_ranks(remeshing.n_forced);
    account.volume.remeshed(fluid_volume());
    account.fluids.remeshed(fluid_volumes());
    if (materials.n_fluids() > 1 && remesher.keeps_volume() && materials.all_incompressible())
    {
      InterfaceCorrection<dim>::apply(account.fluids.excess(), obstacles(contour), fluid_mesh, particles,
                                      migration);
      account.fluids.corrected(fluid_volumes());
    }
    account.momentum.changed(fluid_momentum());
    if (count_on_ranks(fluid_mesh.n_cells()) == 0 && solids.empty())
      throw RunError("Time " + std::to_string(time) +
                     " s: no fluid cell is left, all particles are isolated or have left the domain.");
  }



  template <int dim>
  void Simulator<dim>::exchange_fluid()
  {
    if (const unsigned int n_dropped = count_on_ranks(outlets.drop(particles, fluid_mesh)))
    {
      counters.gone_out += n_dropped;
      account.volume.went_out(fluid_volume());
      account.fluids.went_out(fluid_volumes());
      account.momentum.went_out(fluid_momentum());
    }
    const std::uint64_t first_number = particles.next_number;
    if (inlets.renew(walls, communicator(), particles, fluid_mesh) > 0)
    {
      account.momentum.came_in(fluid_momentum());
      FluidStructure<dim>::refresh(first_number, materials, particles);
    }
  }



  template <int dim>
  double Simulator<dim>::fastest_movement() const
  {
    double fastest = std::numeric_limits<double>::min();
    for (const unsigned int i : fluid_mesh.particles())
      fastest = std::max(fastest, particles.velocity[i].norm() / particles.spacing[i]);
    fastest = Utilities::MPI::max(fastest, communicator());
    // A step that lets inflow move by half of its spacing at most.
    return std::max(fastest, 2. * input.run.largest_movement * inlets.fastest(time, input.run.time_step));
  }



  template <int dim>
  void Simulator<dim>::check_movements() const
  {
    const auto [movement, place] = problem.largest_movement(particles);
    if (movement > 2. * input.run.largest_movement)
    {
      std::ostringstream message;
      message << "the particle at (" << place << ") m moves by " << movement
              << " times its spacing, twice 'Largest movement' is allowed";
      throw RunError(message.str());
    }
  }



  namespace
  {
    /// Facets of solids, with the numbers of their surfaces behind those of the boundaries.
    template <int dim>
    std::vector<WallFacet<dim>> of_solids(std::vector<WallFacet<dim>> facets, const Walls<dim> &walls)
    {
      for (WallFacet<dim> &facet : facets)
        facet.boundary += walls.boundary_names().size();
      return facets;
    }
  } // namespace



  template <int dim>
  Walls<dim> Simulator<dim>::obstacles(const SolidContour<dim> &contour) const
  {
    if (solids.empty())
      return walls;
    std::vector<WallFacet<dim>> facets = walls.facets();
    for (const bool lands : {true, false})
      for (const WallFacet<dim> &facet : of_solids(contour.wall_facets_that_land(lands), walls))
        facets.push_back(facet);
    return Walls<dim>(facets);
  }



  template <int dim>
  std::vector<std::array<unsigned int, dim>> Simulator<dim>::slick_facets() const
  {
    if (!input.surfaces.any_slick())
      return {};
    return SolidContour<dim>(solids.mesh().contour(), particles).facets_that_land(true);
  }



  template <int dim>
  WallStep<dim> Simulator<dim>::with_slick_solids(const WallStep<dim> &rigid,
                                                  const std::vector<Point<dim>> &old_position,
                                                  const double time_step) const
  {
    if (!input.surfaces.any_slick())
      return rigid;
    const SolidContour<dim> contour(solids.mesh().contour(), particles);
    std::vector<WallFacet<dim>> end = of_solids(contour.wall_facets_that_land(true), walls), start = end;
    const auto facets = contour.facets_that_land(true);
    for (unsigned int f = 0; f < start.size(); ++f)
      for (unsigned int v = 0; v < dim; ++v)
        start[f].corners[v] = old_position[facets[f][v]];
    return rigid.with_solids(start, end, time_step);
  }



  template <int dim>
  std::vector<const SurfaceLaw *> Simulator<dim>::surface_laws() const
  {
    std::vector<const SurfaceLaw *> laws = input.geometry.surface_laws();
    for (const auto &law : input.surfaces.laws())
      laws.push_back(law.get());
    return laws;
  }



  template <int dim>
  std::vector<NodeConstraint<dim>> Simulator<dim>::constraints(const WallStep<dim> &wall_step) const
  {
    const WallContact<dim> wall_contact(wall_step);
    std::vector<NodeConstraint<dim>> result;
    result.reserve(fluid_mesh.n_vertices());
    for (const unsigned int particle : fluid_mesh.particles())
      result.push_back(wall_contact.constraint(particle, particles));
    inlets.constrain(particles, fluid_mesh, result);
    return result;
  }



  template class Simulator<2>;
  template class Simulator<3>;
} // namespace Lahar
