// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/plane_polygon.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/wall_shape.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <>
  std::vector<WallFacet<2>> WallShape<2>::facets() const
  {
    std::vector<WallFacet<2>> result;
    const unsigned int n = corners.size();
    for (unsigned int i = 0; i + 1 < n + closed; ++i)
      result.push_back({{{corners[i], corners[(i + 1) % n]}}, lands, boundary, moves, sticks});
    return result;
  }



  template <int dim>
  double WallShape<dim>::estimate_size(const double h) const
  {
    double n = corners.size();
    for (const WallFacet<dim> &facet : facets())
    {
      double longest = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        longest = std::max(longest, facet.corners[c].distance(facet.corners[(c + 1) % dim]));
      n += std::pow(longest / h, dim - 1);
    }
    return n;
  }



  template <>
  std::vector<Point<2>> WallShape<2>::particles(const std::vector<Point<2>> &contacts,
                                                const MeshSize<2> &h) const
  {
    std::vector<Point<2>> kept;
    const unsigned int n_pieces = closed ? corners.size() : corners.size() - 1;
    for (unsigned int i = 0; i < n_pieces; ++i)
    {
      const Point<2> &a = corners[i];
      const Point<2> &b = corners[(i + 1) % corners.size()];
      std::vector<Point<2>> on_piece;
      for (const Point<2> &p : contacts)
        if (distance_to_segment(p, a, b) < touching * h(p) && p.distance(a) > 0.5 * h(p) &&
            p.distance(b) > 0.5 * h(p))
          on_piece.push_back(p);
      std::sort(on_piece.begin(), on_piece.end(), [&a](const Point<2> &p, const Point<2> &q) {
        return p.distance_square(a) < q.distance_square(a);
      });
      kept.push_back(a);
      for (const Point<2> &p : on_piece)
        if (p.distance(kept.back()) > 0.5 * h(p))
          kept.push_back(p);
    }
    if (!closed)
      kept.push_back(corners.back());
    return sample_polyline(kept, h, closed);
  }



  template <>
  std::vector<Point<2>> WallShape<2>::samples(const double h) const
  {
    return sample_polyline(corners, 0.2 * h, closed);
  }



  template <>
  bool WallShape<2>::encloses(const Point<2> &point, const double tolerance) const
  {
    return closed && is_inside(corners, point) && distance_to_contour(corners, point) > tolerance;
  }



  template <>
  bool WallShape<2>::holds(const std::vector<Point<2>> &points, const double tolerance) const
  {
    return closed && std::all_of(points.begin(), points.end(), [&](const Point<2> &point) {
             return is_inside(corners, point) || distance_to_contour(corners, point) < tolerance;
           });
  }



  template <>
  std::vector<std::array<Point<3>, 3>> WallShape<3>::triangles() const
  {
    return mesh_facets.empty() ? PlanePolygon(corners).triangles() : mesh_facets;
  }



  template <>
  std::vector<WallFacet<3>> WallShape<3>::facets() const
  {
    std::vector<WallFacet<3>> result;
    for (const auto &triangle : triangles())
      result.push_back({triangle, lands, boundary, moves, sticks});
    return result;
  }



  template <>
  std::vector<Point<3>> WallShape<3>::particles(const std::vector<Point<3>> &contacts,
                                                const MeshSize<3> &h) const
  {
    std::vector<Point<3>> result;
    PointSet<3> places;
    for (const Point<3> &p : contacts)
      if (places.insert_if_free(p, 0.1 * h(p)))
        result.push_back(p);
    if (mesh_facets.empty())
    {
      for (const Point<3> &p : PlanePolygon(corners).fill(h))
        if (places.near(p, 0.6 * h(p)).empty())
          result.push_back(p);
    }
    else
      for (const auto &[a, b, c] : mesh_facets)
        for (const Point<3> &p : PlanePolygon({a, b, c}).fill(h))
          if (places.insert_if_free(p, 0.6 * h(p)))
            result.push_back(p);
    return result;
  }



  template <>
  std::vector<Point<3>> WallShape<3>::samples(const double h) const
  {
    std::vector<Point<3>> result;
    for (const auto &[a, b, c] : triangles())
    {
      const unsigned int n = 1 + std::max({a.distance(b), b.distance(c), c.distance(a)}) / (0.5 * h);
      for (unsigned int i = 0; i <= n; ++i)
        for (unsigned int j = 0; i + j <= n; ++j)
          result.push_back(a + double(i) / n * (b - a) + double(j) / n * (c - a));
    }
    return result;
  }



  template <>
  bool WallShape<3>::encloses(const Point<3> &, const double) const
  {
    return false;
  }



  template <>
  bool WallShape<3>::holds(const std::vector<Point<3>> &, const double) const
  {
    return false;
  }



  template struct WallShape<2>;
  template struct WallShape<3>;
} // namespace Lahar
