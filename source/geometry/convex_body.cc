// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/convex_body.h>
#include <lahar/geometry/lattice.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lahar
{
  namespace
  {
    /// The work to find the faces grows with the fourth power.
    constexpr unsigned int max_corners = 100;

    /// The points that lie in the plane through @p origin, in order around the normal.
    std::vector<Point<3>> in_order(std::vector<Point<3>> points, const Tensor<1, 3> &normal)
    {
      Point<3> centre;
      for (const Point<3> &p : points)
        centre += Tensor<1, 3>(p) / double(points.size());
      const Tensor<1, 3> x = points[0] - centre, y = cross_product_3d(normal, x);
      const auto angle = [&](const Point<3> &p) { return std::atan2(y * (p - centre), x * (p - centre)); };
      std::sort(points.begin(), points.end(),
                [&](const Point<3> &a, const Point<3> &b) { return angle(a) < angle(b); });
      // A point between two others on one edge is no corner.
      std::vector<Point<3>> corners;
      for (unsigned int i = 0, n = points.size(); i < n; ++i)
      {
        const Tensor<1, 3> a = points[i] - points[(i + n - 1) % n], b = points[(i + 1) % n] - points[i];
        if (cross_product_3d(a, b) * normal > 1e-9 * a.norm() * b.norm())
          corners.push_back(points[i]);
      }
      return corners;
    }
  } // namespace



  ConvexBody::ConvexBody(const std::string &name, const std::vector<Point<3>> &corners)
    : FluidBody<3>(name)
  {
    double size = 0.;
    for (const Point<3> &p : corners)
      size = std::max(size, p.distance(corners[0]));
    const double tolerance = 1e-9 * size;
    for (const Point<3> &p : corners)
      if (std::none_of(points.begin(), points.end(),
                       [&](const Point<3> &q) { return p.distance(q) <= tolerance; }))
        points.push_back(p);

    // Every plane through three of them that has all others on one side holds a face.
    const unsigned int n = points.size();
    if (n > max_corners)
      throw InputError("at most " + std::to_string(max_corners) + " different corners");
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int k = j + 1; k < n; ++k)
        {
          Tensor<1, 3> normal = cross_product_3d(points[j] - points[i], points[k] - points[i]);
          if (i == j || i == k || normal.norm() <= tolerance * size)
            continue;
          normal /= normal.norm();
          std::vector<Point<3>> in_plane;
          double highest = 0., lowest = 0.;
          for (const Point<3> &p : points)
          {
            const double height = normal * (p - points[i]);
            highest             = std::max(highest, height);
            lowest              = std::min(lowest, height);
            if (std::abs(height) <= tolerance)
              in_plane.push_back(p);
          }
          if (lowest < -tolerance && highest > tolerance)
            continue;
          if (highest > tolerance)
            normal *= -1.;
          const bool known = std::any_of(faces.begin(), faces.end(), [&](const PlanePolygon &face) {
            return face.normal() * normal > 1. - 1e-9 &&
                   std::abs(face.signed_distance(points[i])) <= tolerance;
          });
          if (!known && lowest != highest)
            faces.emplace_back(in_order(in_plane, normal));
        }
    const bool flat = std::all_of(points.begin(), points.end(), [&](const Point<3> &p) {
      return faces.empty() || std::abs(faces[0].signed_distance(p)) <= tolerance;
    });
    if (flat)
      throw InputError("at least four corners that do not lie in one plane");
  }



  Box<3> ConvexBody::box() const
  {
    return box_around(points);
  }



  double ConvexBody::volume() const
  {
    double sum = 0.;
    for (const PlanePolygon &face : faces)
      for (const auto &[a, b, c] : face.triangles())
        sum += cross_product_3d(b - a, c - a) * (a - points[0]) / 6.;
    return sum;
  }



  double ConvexBody::signed_distance(const Point<3> &point) const
  {
    double distance = -std::numeric_limits<double>::max();
    for (const PlanePolygon &face : faces)
      distance = std::max(distance, face.signed_distance(point));
    return distance;
  }



  DividedPoints<3> ConvexBody::fill(const MeshSize<3> &h, const MPI_Comm &communicator) const
  {
    std::vector<Point<3>> contour;
    for (const PlanePolygon &face : faces)
      for (const Point<3> &p : face.fill(h))
        contour.push_back(p);
    return fill_inside(*this, contour, h, communicator);
  }



  std::vector<Point<3>> ConvexBody::corners() const
  {
    return points;
  }
} // namespace Lahar
