// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/free_flight.h>

namespace Lahar
{
  template <int dim>
  void move_isolated_particles(const FluidMesh<dim> &mesh, const Tensor<1, dim> &gravity,
                               const double time_step, ParticleCloud<dim> &cloud)
  {
    std::vector<bool> in_mesh(cloud.size(), false);
    for (const unsigned int particle : mesh.particles())
      in_mesh[particle] = true;

    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (!in_mesh[i] && cloud.kind[i] == ParticleKind::fluid)
      {
        cloud.position[i] += time_step * (cloud.velocity[i] + 0.5 * time_step * gravity);
        cloud.velocity[i] += time_step * gravity;
        cloud.acceleration[i]             = gravity;
        cloud.algorithmic_acceleration[i] = gravity;
        cloud.pressure[i]                 = 0.;
        cloud.pressure_rate[i]            = 0.;
      }
  }



  template <int dim>
  void stop_at_walls(const std::vector<Point<dim>> &old_position, const WallStep<dim> &step,
                     ParticleCloud<dim> &cloud)
  {
    const Walls<dim> &walls = step.end();
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      if (cloud.kind[i] != ParticleKind::fluid)
        continue;
      // Both ends of the way in the frame of the wall that stops the particle first.
      const Point<dim> end = cloud.position[i];
      double fraction      = 1.;
      Point<dim> start;
      unsigned int boundary = 0;
      for (const unsigned int facet : step.crossed(old_position[i], end, 0., 1e-3 * cloud.spacing[i]))
        if (!walls.facets()[facet].lands)
        {
          const Point<dim> from = step.carried(walls.facets()[facet].boundary, old_position[i]);
          const double before   = walls.signed_distance(facet, from);
          const double after    = walls.signed_distance(facet, end);
          const double stop     = std::min(std::abs(before), 0.1 * cloud.spacing[i]);
          if (const double part = (std::abs(before) - stop) / std::abs(before - after); part < fraction)
          {
            fraction = part;
            start    = from;
            boundary = walls.facets()[facet].boundary;
          }
        }
      if (fraction < 1.)
      {
        cloud.position[i]                 = start + fraction * (end - start);
        cloud.velocity[i]                 = step.velocity_at_end(boundary, cloud.position[i]);
        cloud.acceleration[i]             = Tensor<1, dim>();
        cloud.algorithmic_acceleration[i] = Tensor<1, dim>();
        // A wall that moves takes it off others along which it slides.
        if (step.moves(boundary))
          for (const int facet : cloud.contact_facets[i])
            if (facet != ParticleCloud<dim>::no_facet)
              cloud.position[i] += ((step.distance_at_start(facet, old_position[i]) < 0. ? -1. : 1.) *
                                      contact_offset * cloud.spacing[i] -
                                    walls.signed_distance(facet, cloud.position[i])) *
                                   walls.normal(facet);
      }
    }
  }



  template void move_isolated_particles<2>(const FluidMesh<2> &, const Tensor<1, 2> &, const double,
                                           ParticleCloud<2> &);
  template void move_isolated_particles<3>(const FluidMesh<3> &, const Tensor<1, 3> &, const double,
                                           ParticleCloud<3> &);
  template void stop_at_walls<2>(const std::vector<Point<2>> &, const WallStep<2> &, ParticleCloud<2> &);
  template void stop_at_walls<3>(const std::vector<Point<3>> &, const WallStep<3> &, ParticleCloud<3> &);
} // namespace Lahar
