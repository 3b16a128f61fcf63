// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_plane_polygon_h
#define lahar_geometry_plane_polygon_h

#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/polygon.h>

#include <array>
#include <vector>

namespace Lahar
{
  /**
   * A convex polygon in space. The corners turn counterclockwise about the normal.
   */
  class PlanePolygon
  {
  public:
    /**
     * @param corners in order, at least three, convex and in one plane up to 1e-6 of their distance.
     * @throws InputError otherwise; the message does not name the polygon.
     */
    explicit PlanePolygon(const std::vector<Point<3>> &corners);

    const std::vector<Point<3>> &corners() const
    {
      return all_corners;
    }

    const Tensor<1, 3> &normal() const
    {
      return unit_normal;
    }

    /// Distance from the plane, positive on the side of the normal, m.
    double signed_distance(const Point<3> &point) const;

    /// Points at the distance @p h, as fill_polygon() places them; those on an edge depend on that edge only.
    std::vector<Point<3>> fill(const MeshSize<3> &h) const;

    /// The polygon as triangles.
    std::vector<std::array<Point<3>, 3>> triangles() const;

  private:
    std::vector<Point<3>> all_corners;
    Tensor<1, 3> unit_normal;
    std::array<Tensor<1, 3>, 2> axes; ///< of the plane, right-handed with the normal
  };
} // namespace Lahar

#endif
