// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/deviator.h>
#include <lahar/assembly/fluid_structure.h>
#include <lahar/boundary/free_flight.h>
#include <lahar/boundary/solid_collision.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/remeshing/volume_correction.h>
#include <lahar/simulator/simulator.h>

#include <sstream>

namespace Lahar
{
  template <int dim>
  void Simulator<dim>::move_particles(const double time_step, const WallStep<dim> &wall_step)
  {
    TimerOutput::Scope scope(timer, "Update");
    const std::vector<Point<dim>> old_position = particles.position;
    const std::vector<FacePressure<dim>> pressures =
      outlets.pressures(fluid_mesh, particles, time + time_step, materials.largest_density() * input.gravity);
    problem.accept(particles, solids);
    advance_history(time_step);
    wall_step.carry_particles(old_position, particles);
    inlets.carry(old_position, particles);
    take_mean_forces(pressures);
    if (input.geometry.has_fluid())
    {
      account.volume.solved(fluid_volume(), inlets.volume());
      account.fluids.solved(fluid_volumes(), inflow_volumes());
      account.momentum.start_step(time_integration.carried_time());
      account.momentum.set(fluid_momentum());
    }

    const std::vector<double> volumes = VolumeCorrection<dim>::cell_volumes(fluid_mesh, particles);
    std::vector<bool> in_mesh(particles.size(), false);
    for (const unsigned int particle : fluid_mesh.particles())
      in_mesh[particle] = true;
    solids.move_particles(in_mesh, particles);
    move_isolated_particles(fluid_mesh, input.gravity, time_step, particles);
    const WallStep<dim> contact_step = with_slick_solids(wall_step, old_position, time_step);
    stop_at_walls(old_position, contact_step, particles);
    const SolidContour<dim> contour(solids.mesh().contour(), particles);
    counters.kept_out += count_on_ranks(
      SolidContour<dim>(contour.facets_that_land(false), particles).keep_out(old_position, particles));
    WallContact<dim>(contact_step).update(old_position, particles);
    if (remesher.keeps_volume())
      VolumeCorrection<dim>::owe_growth(fluid_mesh, volumes, particles);
    migration.update(particles);
    fluid_mesh.move(particles);
    if (input.geometry.has_fluid())
      account.momentum.changed(fluid_momentum());
    counters.cells = count_on_ranks(fluid_mesh.own_cells(particles).size());
  }



  template <int dim>
  void Simulator<dim>::advance_history(const double time_step)
  {
    std::vector<double> before;
    if (has_multipliers())
      before = FluidStructure<dim>::of_cells(fluid_mesh, materials, particles);
    FluidStructure<dim>::advance(fluid_mesh, materials, time_step, migration, particles);
    if (!has_multipliers())
      return;
    std::vector<SymmetricTensor<2, dim>> values = multipliers.values();
    problem.get_multipliers(values);
    // Where the yield stress has grown a smaller part of it carries the same load.
    const std::vector<double> now = FluidStructure<dim>::of_cells(fluid_mesh, materials, particles);
    for (unsigned int c = 0; c < now.size(); ++c)
      values[c] = project_deviator<dim>((1. + before[c]) / (1. + now[c]) * values[c]);
    multipliers.set(fluid_mesh, particles, std::move(values));
  }



  template <int dim>
  void Simulator<dim>::take_mean_forces(const std::vector<FacePressure<dim>> &pressures)
  {
    const auto reactions = problem.reactions();
    std::vector<Tensor<1, dim>> forces(particles.size());
    for (unsigned int v = 0; v < reactions.at_vertices.size(); ++v)
      forces[fluid_mesh.particle(v)] = reactions.at_vertices[v];
    // The solids' particles come first.
    for (unsigned int i = 0; i < solids.mesh().n_contour_nodes() && !reactions.of_slick_solids.empty(); ++i)
      if (particles.kind[i] == ParticleKind::slick_solid)
        forces[i] = reactions.of_slick_solids[i];
    for (unsigned int i = 0; i < particles.size(); ++i)
      particles.reaction[i] = time_integration.mean_force(forces[i], particles.reaction[i]);
    const std::vector<Tensor<1, dim>> on_outlets = Outlets<dim>::forces(pressures, fluid_mesh, particles,
                                                                        outlet_forces.size());
    for (unsigned int b = 0; b < outlet_forces.size(); ++b)
      outlet_forces[b] = time_integration.mean_force(Utilities::MPI::sum(on_outlets[b], communicator()),
                                                     outlet_forces[b]);
  }



  template <int dim>
  void Simulator<dim>::stop_at_collision(const std::vector<Point<dim>> &old_position,
                                         const WallStep<dim> &wall_step)
  {
    const auto place = SolidCollision<dim>::find(solids.mesh(), old_position, solids.state().position,
                                                 wall_step);
    if (!place)
      return;
    output.write_snapshot(snapshot());
    write_checkpoint();
    std::ostringstream message;
    message
      << "Time " << time << " s: solid '" << solids.all_bodies()[place->body].name << "' has run into "
      << (place->wall                        ? "boundary " + input.geometry.wall_name(*place->wall)
          : place->body == place->other_body ? "itself"
                                             : "solid '" + solids.all_bodies()[place->other_body].name + "'")
      << " at (" << place->point
      << ") m. Contact of solids with walls and with each other is not computed: keep them apart by 'Clamped' or "
         "'Driven', or end the run before.";
    throw RunError(message.str());
  }



  template void Simulator<2>::move_particles(const double, const WallStep<2> &);
  template void Simulator<3>::move_particles(const double, const WallStep<3> &);
  template void Simulator<2>::stop_at_collision(const std::vector<Point<2>> &, const WallStep<2> &);
  template void Simulator<3>::stop_at_collision(const std::vector<Point<3>> &, const WallStep<3> &);
} // namespace Lahar
