// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_structure.h>
#include <lahar/boundary/solid_touch.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/boundary/wall_separation.h>
#include <lahar/remeshing/interface_correction.h>
#include <lahar/simulator/automatic_augmentation.h>
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
    remesher.parse_parameters(prm);
    remesher.set_number_of_fluids(materials.n_fluids());
    remesher.set_outside_volumes([this](const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) {
      return inlets.layers(cloud, mesh);
    });
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
    return remesher.region_distance(region.particles, region.mesh, solids.longest_edge(), communicator());
  }



  template <int dim>
  void Simulator<dim>::migrate(const bool keeps_owners)
  {
    migration.migrate(region.particles, region.mesh, region_distance(), solids.mesh().n_contour_nodes(),
                      has_multipliers() ? &region.multipliers.table() : nullptr, keeps_owners);
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
    if (account.counters.steps > 0 && input.geometry.has_fluid())
      remesh(time_step);

    // Not anew where the step is repeated: from rest that would be the same problem with other units.
    choose_augmentations(region.mesh, region.particles, time_step, communicator(), input.geometry.laws());
    NonlinearReport report;
    std::optional<WallStep<dim>> wall_step;
    for (bool accepted = false; !accepted;)
      try
      {
        wall_step.emplace(input.geometry.wall_step(walls, time, time_step));
        // Where the slick solids will be at the end is not known yet.
        const WallStep<dim> contact_step = with_slick_solids(*wall_step, region.particles.position,
                                                             time_step);
        inlets.start_step(region.particles, region.mesh, communicator(), time, time_step);
        problem.start_step(
          {region.mesh, region.particles, solids, migration, materials, input.gravity, time, time_step,
           account.counters.steps == 0, constraints(contact_step), region.remeshing.arrives,
           SlidingContact<dim>::find(region.mesh, region.particles, contact_step, surface_laws()),
           SolidTouch<dim>::find(region.mesh, region.particles, contact_step, slick_facets()),
           region.multipliers.values(),
           FluidStructure<dim>::of_cells(region.mesh, materials, region.particles), outlets});
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
        ++account.counters.rejected;
      }
    step_control->accept(report.iterations);

    const std::vector<Point<dim>> old_position = solids.state().position;
    move_particles(time_step, *wall_step);
    if (wall_step->any_moves())
      walls = Walls<dim>(wall_step->end());
    time += time_step;
    ++account.counters.steps;
    TimerOutput::Scope scope(timer, "Output");
    add_statistics(time_step, report);
    stop_at_collision(old_position, *wall_step);
  }



  template <int dim>
  void Simulator<dim>::remesh(const double time_step)
  {
    TimerOutput::Scope scope(timer, "Remesh");
    if (WallSeparation<dim>::release(input.geometry.tensile_strengths(), walls, region.mesh, region.particles,
                                     communicator()) > 0)
      migration.update(region.particles);
    // What landing has displaced is given back below; it is no part of what leaves here.
    if (input.domain_limit.is_set() || outlets.any())
      account.remeshed(fluid());
    exchange_fluid();
    if (const unsigned int n_dropped = count_on_ranks(
          input.domain_limit.drop_outside(region.particles, region.mesh)))
      account.left(n_dropped, fluid());
    migrate();
    const SolidContour<dim> contour(solids.mesh().contour(), region.particles);
    input.mesh_size.update(region.particles);
    if (has_multipliers())
      region.multipliers.spread(region.mesh, materials.n_fluids(), region.particles, migration);
    try
    {
      region.remeshing = remesher.remesh(region.particles, obstacles(contour),
                                         contour.facets_that_land(false), time_step, region.mesh, migration);
    }
    catch (const RunError &error)
    {
      throw RunError("Time " + std::to_string(time) + " s, remeshing: " + error.what() + ".");
    }
    if (has_multipliers())
      region.multipliers.follow(region.mesh, region.particles);
    FluidStructure<dim>::complete(region.mesh, materials, migration, region.particles);
    account.counters.forced_facets += count_on_ranks(region.remeshing.n_forced);
    account.remeshed(fluid());
    if (materials.n_fluids() > 1 && remesher.keeps_volume() && materials.all_incompressible())
    {
      InterfaceCorrection<dim>::apply(account.fluids.excess(), obstacles(contour), region.mesh,
                                      region.particles, migration);
      account.corrected(fluid());
    }
    account.rearranged(fluid());
    if (count_on_ranks(region.mesh.n_cells()) == 0 && solids.empty())
      throw RunError("Time " + std::to_string(time) +
                     " s: no fluid cell is left, all particles are isolated or have left the domain.");
  }



  template <int dim>
  void Simulator<dim>::exchange_fluid()
  {
    if (const unsigned int n_dropped = count_on_ranks(outlets.drop(region.particles, region.mesh)))
      account.went_out(n_dropped, fluid());
    const std::uint64_t first_number = region.particles.next_number;
    if (inlets.renew(walls, communicator(), region.particles, region.mesh) > 0)
    {
      account.came_in(fluid());
      FluidStructure<dim>::refresh(first_number, materials, region.particles);
    }
  }



  template <int dim>
  double Simulator<dim>::fastest_movement() const
  {
    double fastest = std::numeric_limits<double>::min();
    for (const unsigned int i : region.mesh.particles())
      fastest = std::max(fastest, region.particles.velocity[i].norm() / region.particles.spacing[i]);
    fastest = Utilities::MPI::max(fastest, communicator());
    // A step that lets inflow move by half of its spacing at most.
    return std::max(fastest, 2. * input.run.largest_movement * inlets.fastest(time, input.run.time_step));
  }



  template <int dim>
  void Simulator<dim>::check_movements() const
  {
    const auto [movement, place] = problem.largest_movement(region.particles);
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
    return SolidContour<dim>(solids.mesh().contour(), region.particles).facets_that_land(true);
  }



  template <int dim>
  WallStep<dim> Simulator<dim>::with_slick_solids(const WallStep<dim> &rigid,
                                                  const std::vector<Point<dim>> &old_position,
                                                  const double time_step) const
  {
    if (!input.surfaces.any_slick())
      return rigid;
    const SolidContour<dim> contour(solids.mesh().contour(), region.particles);
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
    result.reserve(region.mesh.n_vertices());
    for (const unsigned int particle : region.mesh.particles())
      result.push_back(wall_contact.constraint(particle, region.particles));
    inlets.constrain(region.particles, region.mesh, result);
    return result;
  }



  template class Simulator<2>;
  template class Simulator<3>;
} // namespace Lahar
