// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_free_flight_h
#define lahar_boundary_free_flight_h

#include <lahar/boundary/wall_step.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>

namespace Lahar
{
  /// Move the fluid particles without a cell, which fly freely: p = 0, a = g, v ← v + g Δt, x ← x + Δt (v_n + v)/2.
  template <int dim>
  void move_isolated_particles(const FluidMesh<dim> &mesh, const Tensor<1, dim> &gravity,
                               const double time_step, ParticleCloud<dim> &cloud);

  /**
   * Stop fluid particles whose way from @p old_position (by particle) leads through a wall that carries particles: they
   * stay a tenth of their spacing in front of it and take its velocity. On other walls they land (WallContact).
   */
  template <int dim>
  void stop_at_walls(const std::vector<Point<dim>> &old_position, const WallStep<dim> &step,
                     ParticleCloud<dim> &cloud);
} // namespace Lahar

#endif
