// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>
#include <lahar/remeshing/solid_interior.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// The cosine between an edge and a normal below which the edge is no chord of a bent face.
    constexpr double behind = -0.2;
  } // namespace



  template <int dim>
  SolidInterior<dim>::SolidInterior(const std::vector<Facet> &facets, const ParticleCloud<dim> &cloud)
  {
    for (const Facet &facet : facets)
    {
      std::array<Point<dim>, dim> corners;
      for (unsigned int c = 0; c < dim; ++c)
        corners[c] = cloud.position[facet[c]];
      const Tensor<1, dim> normal = facet_normal(corners);
      for (const unsigned int node : facet)
        normals[node].push_back(normal / normal.norm());
    }
  }



  template <int dim>
  bool SolidInterior<dim>::is_inward(const unsigned int node, const Tensor<1, dim> &direction) const
  {
    const auto entry = normals.find(node);
    return entry != normals.end() &&
           std::all_of(entry->second.begin(), entry->second.end(),
                       [&](const Tensor<1, dim> &n) { return n * direction < behind; });
  }



  template <int dim>
  bool SolidInterior<dim>::holds_edge_of(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud) const
  {
    for (unsigned int a = 0; a <= dim; ++a)
      for (unsigned int b = 0; b <= dim; ++b)
        if (const bool to_fluid = cloud.kind[simplex[b]] == ParticleKind::fluid;
            cloud.kind[simplex[a]] == ParticleKind::solid &&
            (to_fluid || (cloud.kind[simplex[b]] == ParticleKind::solid && b < a)))
        {
          const Tensor<1, dim> along     = cloud.position[simplex[b]] - cloud.position[simplex[a]];
          const Tensor<1, dim> direction = along / along.norm();
          if (is_inward(simplex[a], direction) && (to_fluid || is_inward(simplex[b], -direction)))
            return true;
        }
    return false;
  }



  template class SolidInterior<2>;
  template class SolidInterior<3>;
} // namespace Lahar
