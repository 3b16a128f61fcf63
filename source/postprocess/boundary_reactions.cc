// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/normal_parts.h>
#include <lahar/postprocess/boundary_reactions.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// The force of a particle of the fluid that touches facets of walls.
    template <int dim, typename Use>
    void divide_force(const Snapshot<dim> &snapshot, const unsigned int particle, const Use &use)
    {
      const Tensor<1, dim> force = -snapshot.cloud.reaction[particle];
      const Point<dim> &place    = snapshot.cloud.position[particle];
      std::vector<unsigned int> facets;
      bool is_one = true;
      for (const int facet : snapshot.cloud.contact_facets[particle])
        if (facet != ParticleCloud<dim>::no_facet &&
            static_cast<unsigned int>(facet) < snapshot.walls.facets().size()) // else it is one of a solid
        {
          facets.push_back(facet);
          is_one = is_one &&
                   snapshot.walls.facets()[facet].boundary == snapshot.walls.facets()[facets[0]].boundary;
        }
      if (facets.empty())
        return;
      if (is_one)
      {
        use(snapshot.walls.facets()[facets[0]].boundary, force, place);
        return;
      }
      std::vector<Tensor<1, dim>> normals;
      for (const unsigned int facet : facets)
        normals.push_back(snapshot.walls.normal(facet));
      const std::vector<double> shares = normal_parts(normals, force);
      Tensor<1, dim> rest              = force;
      for (unsigned int k = 0; k < facets.size(); ++k)
      {
        const Tensor<1, dim> part = shares[k] * normals[k];
        use(snapshot.walls.facets()[facets[k]].boundary, part, place);
        rest -= part;
      }
      unsigned int first = snapshot.walls.facets()[facets[0]].boundary;
      for (const unsigned int facet : facets)
        first = std::min(first, snapshot.walls.facets()[facet].boundary);
      use(first, rest, place);
    }
  } // namespace



  template <int dim>
  void for_each_boundary_force(
    const Snapshot<dim> &snapshot,
    const std::function<void(const unsigned int, const Tensor<1, dim> &, const Point<dim> &)> &use)
  {
    for (const unsigned int particle : snapshot.mesh.particles())
      if (snapshot.cloud.is_own(particle))
      {
        if (snapshot.cloud.kind[particle] == ParticleKind::wall)
          use(snapshot.cloud.part[particle], -snapshot.cloud.reaction[particle],
              snapshot.cloud.position[particle]);
        else if (snapshot.cloud.in_contact(particle))
          divide_force(snapshot, particle, use);
      }
  }



  template void for_each_boundary_force(
    const Snapshot<2> &,
    const std::function<void(const unsigned int, const Tensor<1, 2> &, const Point<2> &)> &);
  template void for_each_boundary_force(
    const Snapshot<3> &,
    const std::function<void(const unsigned int, const Tensor<1, 3> &, const Point<3> &)> &);
} // namespace Lahar
