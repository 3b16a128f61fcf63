// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_polygon_h
#define lahar_geometry_polygon_h

#include <deal.II/base/point.h>

#include <lahar/geometry/graded_points.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// A closed polygon without self-intersections; the last corner is joined to the first.
  using Polygon = std::vector<Point<2>>;

  /// Signed area, positive for corners in counterclockwise order, m².
  double signed_area(const Polygon &polygon);

  /// Whether @p point lies inside the polygon (on its contour: either answer).
  bool is_inside(const Polygon &polygon, const Point<2> &point);

  /// Distance of @p point from the segment between @p a and @p b, m.
  double distance_to_segment(const Point<2> &point, const Point<2> &a, const Point<2> &b);

  /// Distance of @p point from the polygon's contour, m.
  double distance_to_contour(const Polygon &polygon, const Point<2> &point);

  /// Whether two edges that are no neighbours meet, or a corner lies twice in the list.
  bool is_self_intersecting(const Polygon &polygon);

  /**
   * Divide a polyline into pieces of nearly equal length, at most 1.5 @p h long and h on average; where h changes along
   * the line, with nearly equal integrals ∫ ds/h. All corners are kept; a @p closed line is joined to its first point,
   * which is not repeated.
   */
  std::vector<Point<2>> sample_polyline(const std::vector<Point<2>> &corners, const SizeFunction<2> &h,
                                        const bool closed);

  /// The same with one h everywhere.
  std::vector<Point<2>> sample_polyline(const std::vector<Point<2>> &corners, const double h,
                                        const bool closed);

  /**
   * Points in a region at the distance @p h: those of its @p contour first, inside, where @p depth says that the contour
   * is more than 0.55 h away (the distance from the contour, negative outside), lattices of equilateral triangles of the
   * sizes @p levels (with_graded_lattice()), smoothed towards the contour and from one lattice to the next
   * (smooth()). Collective.
   */
  DividedPoints<2> fill_contour(const std::vector<Point<2>> &contour, const SizeFunction<2> &depth,
                                const SizeFunction<2> &h, const std::vector<double> &levels,
                                const MPI_Comm &communicator);

  /**
   * Points in a polygon at the distance @p h: on the contour as sample_polyline() places them, inside as
   * fill_contour(). The contour's points come first.
   */
  DividedPoints<2> fill_polygon(const Polygon &polygon, const SizeFunction<2> &h,
                                const std::vector<double> &levels, const MPI_Comm &communicator);

  /// The same with one h everywhere, all of them on this rank.
  std::vector<Point<2>> fill_polygon(const Polygon &polygon, const double h);
} // namespace Lahar

#endif
