// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/polygon_body.h>
#include <lahar/geometry/symmetry.h>

namespace Lahar
{
  PolygonBody::PolygonBody(const std::string &name, const Polygon &contour)
    : FluidBody<2>(name)
    , contour(contour)
  {}



  Box<2> PolygonBody::box() const
  {
    return box_around(contour);
  }



  double PolygonBody::volume() const
  {
    if (!Symmetry::is_rotational())
      return signed_area(contour);
    // ∫ 2π x = ∮ π x² dy
    double sum = 0.;
    for (unsigned int i = 0; i < contour.size(); ++i)
    {
      const Point<2> &a = contour[i], &b = contour[(i + 1) % contour.size()];
      sum += numbers::PI / 3. * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]);
    }
    return sum;
  }



  double PolygonBody::signed_distance(const Point<2> &point) const
  {
    const double distance = distance_to_contour(contour, point);
    return is_inside(contour, point) ? -distance : distance;
  }



  double PolygonBody::estimate_size(const double h) const
  {
    // A contour may be far longer than that of the box.
    double n = FluidBody<2>::estimate_size(h);
    for (unsigned int i = 0; i < contour.size(); ++i)
      n += contour[i].distance(contour[(i + 1) % contour.size()]) / h;
    return n;
  }



  DividedPoints<2> PolygonBody::fill(const MeshSize<2> &h, const MPI_Comm &communicator) const
  {
    return fill_polygon(contour, h, h.levels(), communicator);
  }



  std::vector<Point<2>> PolygonBody::corners() const
  {
    return contour;
  }
} // namespace Lahar
