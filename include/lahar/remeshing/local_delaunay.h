#ifndef lahar_remeshing_local_delaunay_h
#define lahar_remeshing_local_delaunay_h

#include <lahar/remeshing/delaunay.h>

#include <functional>

namespace Lahar
{
  /**
   * Those Delaunay simplices of all @p points that @p matters is true for, without triangulating all points.
   *
   * A simplex that matters must have a point of its own among its corners (@p own), no edge longer than @p reach, and a
   * volume that its circumsphere can be computed from: R below 1e8 times the longest edge.
   *
   * The points known at first are those in the bounding box of the own ones, widened by the reach on all sides. The
   * result is that of all points:
   * - No simplex is missing. Its corners lie within the reach of an own point, so they are known; a Delaunay simplex of
   *   all points is one of any part that has its corners.
   * - None is too many. If no unknown point lies in its circumball, no point contradicts it. So it is if the ball lies
   *   in the box, as that of every simplex with 2R ≤ reach does. In the balls of others, flat simplices of the
   *   surface, unknown points are searched for; of each ball the one nearest to the simplex becomes known, and so on
   *   until there is none.
   *
   * Balls are searched with a radius larger by 1e-6, beyond rounding; exact predicates decide which of the points
   * found there lie in the ball.
   *
   * @return the simplices in no special order, their corners in canonical() order. Not collective.
   */
  template <int dim>
  std::vector<Simplex<dim>> local_delaunay(const std::vector<Point<dim>> &points,
                                           const std::vector<bool> &own, const double reach,
                                           const std::function<bool(const Simplex<dim> &)> &matters);
} // namespace Lahar

#endif
