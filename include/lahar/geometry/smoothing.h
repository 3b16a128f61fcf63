// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_smoothing_h
#define lahar_geometry_smoothing_h

#include <lahar/geometry/graded_points.h>

#include <functional>
#include <vector>

namespace Lahar
{
  /// How the points of a body move before it gets its first mesh.
  template <int dim>
  struct Smoothing
  {
    unsigned int n_sweeps;
    SizeFunction<dim> h;
    double coarsest; ///< the largest h, m
    std::function<bool(const unsigned int, const Point<dim> &)>
      may_move;                                        ///< which points, by number and present place
    std::function<bool(const Point<dim> &)> may_stand; ///< where
  };

  /**
   * Move each point that may, a few times and all at once, to the mean of its Delaunay neighbours q,
   *
   *   Σ n_q w_q q / Σ n_q w_q,   w_q = h_0 / h((p + q)/2),
   *
   * n_q the number of simplices that both share, h_0 the largest h; but not where it must not stand.
   *
   * Each rank moves its own points; it triangulates what is around them. A sum has its terms in the order of the
   * neighbours' numbers, so that the result is to the last bit the same on any number of ranks. Collective.
   */
  template <int dim>
  void smooth(const Smoothing<dim> &smoothing, const MPI_Comm &communicator, DividedPoints<dim> &points);
} // namespace Lahar

#endif
