// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_convex_body_h
#define lahar_geometry_convex_body_h

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/plane_polygon.h>

namespace Lahar
{
  /**
   * The convex hull of points in space: boxes, wedges, prisms. Each of its plane faces is filled as a polygon, its inside
   * by fill_inside().
   */
  class ConvexBody : public FluidBody<3>
  {
  public:
    /// @param corners in any order; points inside the hull and corners given twice do no harm.
    /// @throws InputError if they lie in a plane or are more than 100.
    ConvexBody(const std::string &name, const std::vector<Point<3>> &corners);

    Box<3> box() const override;
    double volume() const override;
    double signed_distance(const Point<3> &point) const override;
    DividedPoints<3> fill(const MeshSize<3> &h, const MPI_Comm &communicator) const override;
    std::vector<Point<3>> corners() const override;

  private:
    std::vector<Point<3>> points;
    std::vector<PlanePolygon> faces; ///< normals point outwards
  };
} // namespace Lahar

#endif
