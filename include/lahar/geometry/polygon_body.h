// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_polygon_body_h
#define lahar_geometry_polygon_body_h

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/polygon.h>

namespace Lahar
{
  /// A polygon, its corners in counterclockwise order; filled by fill_polygon().
  class PolygonBody : public FluidBody<2>
  {
  public:
    PolygonBody(const std::string &name, const Polygon &contour);

    Box<2> box() const override;
    double volume() const override;
    double signed_distance(const Point<2> &point) const override;
    double estimate_size(const double h) const override;
    DividedPoints<2> fill(const MeshSize<2> &h, const MPI_Comm &communicator) const override;
    std::vector<Point<2>> corners() const override;

  private:
    Polygon contour;
  };
} // namespace Lahar

#endif
