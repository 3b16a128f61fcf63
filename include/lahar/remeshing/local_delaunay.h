// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_local_delaunay_h
#define lahar_remeshing_local_delaunay_h

#include <lahar/geometry/delaunay.h>
#include <lahar/remeshing/migration.h>

#include <functional>

namespace Lahar
{
  /**
   * Those Delaunay simplices of all ranks' particles that @p matters is true for on this rank, without triangulating all
   * particles.
   *
   * A simplex that matters must have a particle of @p own among its corners, no edge longer than @p reach, and a volume
   * that its circumsphere can be computed from: R below 1e8 times the longest edge. The particles in @p own belong to
   * this rank.
   *
   * The points used at first are the particles in the bounding box of @p own, widened by the reach on all sides. The
   * result is that of all points:
   * - No simplex is missing. Its corners lie within the reach of an own point, so they are used; a Delaunay simplex of
   *   all points is one of any part that has its corners.
   * - None is too many. If no unused point lies in its circumball, no point contradicts it. So it is if the ball lies
   *   in the box, as that of every simplex with 2R ≤ reach does. In the balls of others, flat simplices of the
   *   surface, unused points are searched for, among the particles that this rank knows and, where the ball leaves its
   *   region, among those of the other ranks (FarPoints); of each ball the nearest one to the simplex is used, and so on
   *   until there is none.
   *
   * Balls are searched with a radius larger by 1e-6, beyond rounding; exact predicates decide which of the points
   * found there lie in the ball.
   *
   * @return the simplices in no special order, their corners in canonical() order. Collective.
   */
  template <int dim>
  std::vector<Simplex<dim>>
  local_delaunay(const ParticleCloud<dim> &cloud, const std::vector<bool> &own, const double reach,
                 const std::function<bool(const Simplex<dim> &)> &matters, const Migration<dim> &migration);

  /// The arguments of local_delaunay().
  template <int dim>
  struct WantedSimplices
  {
    const ParticleCloud<dim> &cloud;
    const std::vector<bool> &own;
    double reach; ///< m
    const std::function<bool(const Simplex<dim> &)> &matters;
    const Migration<dim> &migration;
  };

  /**
   * The same of the constrained Delaunay triangulation with the given segments between particles that all ranks know.
   *
   * Points that a segment hides do not contradict a triangle; as using them does not make it go away, the number of
   * points that are used of its ball doubles each time.
   * @param n_required of the segments come first, which must not cross; see ConstrainedDelaunay.
   * @param forced see ConstrainedDelaunay::forced().
   * @throws RunError if two of these cross.
   */
  std::vector<Simplex<2>> local_constrained_delaunay(const WantedSimplices<2> &wanted,
                                                     const std::vector<std::array<unsigned int, 2>> &segments,
                                                     const unsigned int n_required,
                                                     std::vector<bool> &forced);
} // namespace Lahar

#endif
