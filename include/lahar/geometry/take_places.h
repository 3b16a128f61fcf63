// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_take_places_h
#define lahar_geometry_take_places_h

#include <lahar/geometry/divided_points.h>

#include <functional>
#include <vector>

namespace Lahar
{
  /// Whether a point, the first one by place and number, cannot stand where the second one stands.
  template <int dim>
  using IsInTheWay =
    std::function<bool(const Point<dim> &, const unsigned int, const Point<dim> &, const unsigned int)>;

  /**
   * Points take their places one after the other, in the order of their numbers, unless one that stands by then is in
   * the way.
   *
   * Ranks decide of their own points in rounds: a point falls as soon as one in its way stands, and stands as soon as
   * all that are in its way have fallen; after each round the ranks tell their neighbours. Each round decides of the
   * first point that waits, so that the rounds end, with what one rank finds that takes point after point.
   *
   * @param is_free by index of this rank's points: whether nothing else keeps it from its place.
   * @param clearance as a function of the place: only points nearer than this are in the way, m.
   * @return by index of this rank's points: whether it stands. Collective.
   */
  template <int dim>
  std::vector<bool> take_places(const DividedPoints<dim> &points, const std::vector<bool> &is_free,
                                const std::function<double(const Point<dim> &)> &clearance,
                                const IsInTheWay<dim> &is_in_the_way, const MPI_Comm &communicator);
} // namespace Lahar

#endif
