// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_solid_interior_h
#define lahar_remeshing_solid_interior_h

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/particles/particle_cloud.h>

#include <map>
#include <vector>

namespace Lahar
{
  /**
   * The inside of solids, as far as simplices with corners on their contours see it. In space a contour is no
   * constraint of the triangulation: below a foot that the ground does not quite touch, or at the rim of a face, a
   * simplex may reach from the fluid around the rim and lie inside the solid, though none of its edges passes through a
   * facet.
   *
   * An edge leads into a solid at a node if it goes behind all facets there, by more than chords of a bent face do: with
   * the outward normals n of the facets at a, and d the unit vector from a to b, max n·d < −0.2. Where the contour is
   * convex this is the inside at a node, and a part of it where it is not. An edge between two nodes of contours is
   * inside if it leads inwards at both ends; one to a particle of the fluid, as from a front over its crest, if it does
   * at the node.
   */
  template <int dim>
  class SolidInterior
  {
  public:
    using Facet = std::array<unsigned int, dim>;

    /// @param facets of the solids' contours by particle, normals out of the solid.
    SolidInterior(const std::vector<Facet> &facets, const ParticleCloud<dim> &cloud);

    /// Whether an edge of the simplex leads through the inside of a solid.
    bool holds_edge_of(const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud) const;

  private:
    /// Whether a unit vector leads from a node of a contour to the inside.
    bool is_inward(const unsigned int node, const Tensor<1, dim> &direction) const;

    std::map<unsigned int, std::vector<Tensor<1, dim>>> normals; ///< of the facets at each node
  };
} // namespace Lahar

#endif
