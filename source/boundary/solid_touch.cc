// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/solid_touch.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  std::vector<SolidTouch<dim>>
  SolidTouch<dim>::find(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                        const WallStep<dim> &step,
                        const std::vector<std::array<unsigned int, dim>> &solid_facets)
  {
    std::vector<SolidTouch> result;
    if (solid_facets.empty())
      return result;
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    {
      const unsigned int i = mesh.particle(v);
      const auto &slots    = cloud.contact_facets[i];
      const bool is_alone  = std::count(slots.begin(), slots.end(), ParticleCloud<dim>::no_facet) == dim - 1;
      for (const int facet : slots)
        if (facet != ParticleCloud<dim>::no_facet && step.deforms(facet))
          result.push_back({v, static_cast<unsigned int>(facet), solid_facets[facet - step.n_rigid_facets()],
                            step.distance_at_start(facet, cloud.position[i]),
                            std::pow(cloud.spacing[i], dim - 1),
                            is_alone ? cloud.reaction[i] * step.end().normal(facet) : 0.});
    }
    return result;
  }



  template struct SolidTouch<2>;
  template struct SolidTouch<3>;
} // namespace Lahar
