#include <lahar/boundary/free_flight.h>
#include <lahar/boundary/slip_condition.h>

namespace Lahar
{
  template <int dim>
  void move_isolated_particles(const FluidMesh<dim> &mesh, const Walls<dim> &walls,
                               const Tensor<1, dim> &gravity, const double time_step,
                               ParticleCloud<dim> &cloud)
  {
    std::vector<bool> in_mesh(cloud.size(), false);
    for (const unsigned int particle : mesh.particles())
      in_mesh[particle] = true;

    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      if (in_mesh[i] || cloud.kind[i] != ParticleKind::fluid)
        continue;
      SlipCondition<dim>::release(i, cloud);
      const Point<dim> start = cloud.position[i];
      cloud.position[i] += time_step * (cloud.velocity[i] + 0.5 * time_step * gravity);
      cloud.velocity[i] += time_step * gravity;
      cloud.acceleration[i]  = gravity;
      cloud.pressure[i]      = 0.;
      cloud.pressure_rate[i] = 0.;

      // Stop in front of the nearest no-slip facet in the way.
      const Tensor<1, dim> path = cloud.position[i] - start;
      double fraction           = 1.;
      for (const unsigned int facet : walls.crossed(start, cloud.position[i], 0.))
        if (!walls.facets()[facet].slip)
        {
          const double before = walls.signed_distance(facet, start);
          const double after  = walls.signed_distance(facet, cloud.position[i]);
          const double stop   = std::min(std::abs(before), 0.1 * cloud.spacing[i]);
          fraction            = std::min(fraction, (std::abs(before) - stop) / std::abs(before - after));
        }
      if (fraction < 1.)
      {
        cloud.position[i] = start + fraction * path;
        cloud.velocity[i] = Tensor<1, dim>();
      }
    }
  }



  template void move_isolated_particles<2>(const FluidMesh<2> &, const Walls<2> &, const Tensor<1, 2> &,
                                           const double, ParticleCloud<2> &);
  template void move_isolated_particles<3>(const FluidMesh<3> &, const Walls<3> &, const Tensor<1, 3> &,
                                           const double, ParticleCloud<3> &);
} // namespace Lahar
