// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_solid_collision_h
#define lahar_boundary_solid_collision_h

#include <lahar/boundary/wall_step.h>
#include <lahar/solid/solid_mesh.h>

#include <optional>

namespace Lahar
{
  /**
   * Where a solid has run into a rigid wall, into another solid or into itself, which nothing prevents: the contact of
   * solids is not computed.
   *
   * A solid has run into a wall where an edge of its contour passes through a facet of the wall or an edge of the wall
   * through a facet of the contour, or where the path of one of its nodes in the last step did; into a solid where an edge
   * of one contour passes through a facet of the other that it shares no node with. Both ends of an edge or path must lie
   * more than a tenth of the facets' size off the facet, and a wall's edge must pass that far from the facet's rim,
   * whose corners lie that far before and behind the wall: solids may touch walls, and the edge of one that bends above a
   * floor may dip into it a little. Where an edge passes through the facet as drawn already the two have not run into
   * each other: the foot of a solid follows rough ground at its nodes only.
   */
  template <int dim>
  class SolidCollision
  {
  public:
    struct Place
    {
      Point<dim> point;
      unsigned int body = 0;            ///< of the solid
      std::optional<unsigned int> wall; ///< the facet of the wall; without it the other solid is
      unsigned int other_body = 0;
    };

    /// The first place found; nothing where none is. @param step the walls in the step that moved the nodes from
    /// @p old_position to @p position.
    static std::optional<Place> find(const SolidMesh<dim> &mesh, const std::vector<Point<dim>> &old_position,
                                     const std::vector<Point<dim>> &position, const WallStep<dim> &step);
  };
} // namespace Lahar

#endif
