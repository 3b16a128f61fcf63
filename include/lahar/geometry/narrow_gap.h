// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_narrow_gap_h
#define lahar_geometry_narrow_gap_h

#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/walls.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The narrowest gap between two walls, two solids or a wall and a solid, that has too few mesh sizes across for a flow:
   * facets of different owners that face each other within 30°. A gap below 0.1 h is closed. In space a gap that walls
   * enclose within ten of its widths, in eight directions along it, is the inside of a body that they make.
   */
  template <int dim>
  struct NarrowGap
  {
    double width = 0.; ///< m
    double ratio = 0.; ///< mesh sizes across
    Point<dim> place;
    std::string owner, other_owner;

    /**
     * @param owners by facet.
     * @param is_filled whether a point lies in a wall or solid that is a body.
     * @param most mesh sizes across from which on a gap is wide enough.
     * @return nothing where there is no such gap.
     */
    static std::optional<NarrowGap> find(const std::vector<WallFacet<dim>> &facets,
                                         const std::vector<std::string> &owners,
                                         const std::function<bool(const Point<dim> &)> &is_filled,
                                         const MeshSize<dim> &h, const double most);
  };
} // namespace Lahar

#endif
