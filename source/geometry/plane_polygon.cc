// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/plane_polygon.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  PlanePolygon::PlanePolygon(const std::vector<Point<3>> &corners)
    : all_corners(corners)
  {
    const unsigned int n = corners.size();
    double size          = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      // The sum of the triangles' areas, which is a vector along the normal (Newell).
      unit_normal += 0.5 * cross_product_3d(corners[i] - corners[0], corners[(i + 1) % n] - corners[0]);
      size = std::max(size, corners[i].distance(corners[0]));
    }
    const double area = unit_normal.norm();
    if (n < 3 || !(area > 1e-6 * size * size))
      throw InputError("at least three corners that do not lie on a line");
    unit_normal /= area;
    for (unsigned int i = 0; i < n; ++i)
    {
      if (std::abs(signed_distance(corners[i])) > 1e-6 * size)
        throw InputError("corners in one plane");
      const Tensor<1, 3> a = corners[(i + 1) % n] - corners[i],
                         b = corners[(i + 2) % n] - corners[(i + 1) % n];
      if (!(cross_product_3d(a, b) * unit_normal > -1e-9 * a.norm() * b.norm()) || !(a.norm() > 1e-9 * size))
        throw InputError("a convex polygon, its corners in order and each once");
    }
    axes[0] = (corners[1] - corners[0]) / corners[1].distance(corners[0]);
    axes[1] = cross_product_3d(unit_normal, axes[0]);
  }



  double PlanePolygon::signed_distance(const Point<3> &point) const
  {
    return unit_normal * (point - all_corners[0]);
  }



  std::vector<Point<3>> PlanePolygon::fill(const MeshSize<3> &h) const
  {
    Polygon polygon;
    for (const Point<3> &corner : all_corners)
      polygon.emplace_back(axes[0] * (corner - all_corners[0]), axes[1] * (corner - all_corners[0]));
    const auto in_space = [this](const Point<2> &p) {
      return all_corners[0] + p[0] * axes[0] + p[1] * axes[1];
    };
    std::vector<Point<3>> points;
    const DividedPoints<2> in_plane = fill_polygon(
      polygon, [&](const Point<2> &p) { return h(in_space(p)); }, h.levels(), MPI_COMM_SELF);
    for (const Point<2> &p : in_plane.position)
      points.push_back(in_space(p));
    return points;
  }



  std::vector<std::array<Point<3>, 3>> PlanePolygon::triangles() const
  {
    std::vector<std::array<Point<3>, 3>> result;
    for (unsigned int i = 2; i < all_corners.size(); ++i)
      result.push_back({{all_corners[0], all_corners[i - 1], all_corners[i]}});
    return result;
  }
} // namespace Lahar
