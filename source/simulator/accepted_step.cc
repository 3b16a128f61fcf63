// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/deviator.h>
#include <lahar/assembly/fluid_structure.h>
#include <lahar/boundary/free_flight.h>
#include <lahar/boundary/solid_collision.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/volume_correction.h>
#include <lahar/simulator/simulator.h>

#include <sstream>

namespace Lahar
{
  template <int dim>
  void Simulator<dim>::move_particles(const double time_step, const WallStep<dim> &wall_step)
  {
    TimerOutput::Scope scope(timer, "Update");
    const std::vector<Point<dim>> old_position = region.particles.position;
    const std::vector<FacePressure<dim>> pressures =
      outlets.pressures(region.mesh, region.particles, time + time_step,
                        materials.largest_density() * input.gravity);
    const TimeIntegration &integration = problem.time_integration();
    const auto before = account.end_step(integration.carried_time(), integration.force_lag(), fluid());
    const std::map<unsigned int, double> left_out = volumes_of_left_out();
    problem.accept(region.particles, solids);
    advance_history(time_step);
    wall_step.carry_particles(old_position, region.particles);
    inlets.carry(old_position, region.particles);
    take_mean_forces(pressures);
    std::vector<double> volumes = VolumeCorrection<dim>::cell_volumes(region.mesh, region.particles);
    std::vector<double> growth(materials.n_fluids(), 0.);
    for (const auto &[c, volume] : left_out)
    {
      if (region.particles.is_own(region.mesh.particle_cells()[c]))
        growth[region.mesh.fluid(c)] += volumes[c] - volume;
      volumes[c] = volume;
    }
    if (input.geometry.has_fluid())
      account.solved(before, growth, fluid());

    std::vector<bool> in_mesh(region.particles.size(), false);
    for (const unsigned int particle : region.mesh.particles())
      in_mesh[particle] = true;
    solids.move_particles(in_mesh, region.particles);
    move_isolated_particles(region.mesh, input.gravity, time_step, region.particles);
    const WallStep<dim> contact_step = with_slick_solids(wall_step, old_position, time_step);
    stop_at_walls(old_position, contact_step, region.particles);
    const SolidContour<dim> contour(solids.mesh().contour(), region.particles);
    account.counters.kept_out += count_on_ranks(
      SolidContour<dim>(contour.facets_that_land(false), region.particles)
        .keep_out(old_position, region.particles));
    std::vector<bool> flies = in_mesh;
    flies.flip();
    WallContact<dim>(contact_step, input.geometry.tensile_strengths())
      .update(old_position, region.particles, flies);
    if (remesher.keeps_volume())
      VolumeCorrection<dim>::owe_growth(region.mesh, volumes, region.particles);
    migration.update(region.particles);
    region.mesh.move(region.particles);
    if (input.geometry.has_fluid())
      account.rearranged(fluid());
    account.counters.cells = count_on_ranks(region.mesh.own_cells(region.particles).size());
  }



  template <int dim>
  std::map<unsigned int, double> Simulator<dim>::volumes_of_left_out() const
  {
    std::map<unsigned int, double> volumes;
    for (const unsigned int c : problem.left_out_cells())
      volumes[c] = body_volume<dim>(
        corners_of<dim>(region.mesh.particle_cells()[c], region.particles.position));
    return volumes;
  }



  template <int dim>
  void Simulator<dim>::advance_history(const double time_step)
  {
    std::vector<double> before;
    if (has_multipliers())
      before = FluidStructure<dim>::of_cells(region.mesh, materials, region.particles);
    FluidStructure<dim>::advance(region.mesh, materials, time_step, migration, region.particles);
    if (!has_multipliers())
      return;
    std::vector<SymmetricTensor<2, dim>> values = region.multipliers.values();
    problem.get_multipliers(values);
    // Where the yield stress has grown a smaller part of it carries the same load.
    const std::vector<double> now = FluidStructure<dim>::of_cells(region.mesh, materials, region.particles);
    for (unsigned int c = 0; c < now.size(); ++c)
      values[c] = project_deviator<dim>((1. + before[c]) / (1. + now[c]) * values[c]);
    region.multipliers.set(region.mesh, region.particles, std::move(values));
  }



  template <int dim>
  void Simulator<dim>::take_mean_forces(const std::vector<FacePressure<dim>> &pressures)
  {
    const TimeIntegration &integration = problem.time_integration();
    const auto reactions               = problem.reactions();
    std::vector<Tensor<1, dim>> forces(region.particles.size());
    for (unsigned int v = 0; v < reactions.at_vertices.size(); ++v)
      forces[region.mesh.particle(v)] = reactions.at_vertices[v];
    // The solids' particles come first.
    for (unsigned int i = 0; i < solids.mesh().n_contour_nodes() && !reactions.of_slick_solids.empty(); ++i)
      if (region.particles.kind[i] == ParticleKind::slick_solid)
        forces[i] = reactions.of_slick_solids[i];
    for (unsigned int i = 0; i < region.particles.size(); ++i)
      region.particles.reaction[i] = integration.mean_force(forces[i], region.particles.reaction[i]);
    outlets.take_forces(pressures, region.mesh, region.particles, communicator(),
                        [&](const Tensor<1, dim> &force, const Tensor<1, dim> &old_mean_force) {
                          return integration.mean_force(force, old_mean_force);
                        });
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
