// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_smoothing_h
#define lahar_geometry_smoothing_h

#include <deal.II/base/mpi.h>

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
      may_move;                                        ///< which points, by index and present place
    std::function<bool(const Point<dim> &)> may_stand; ///< where
  };

  /**
   * Move each point that may, a few times and all at once, to the mean of its Delaunay neighbours with the weights h_0/h
   * of the middle between the two, h_0 the largest h, once for each simplex that both share; not where it must not stand.
   *
   * All ranks have all points; each triangulates those around its part of the points that may move, which the parts of
   * space are divided into by halving, and tells the others where these go. A sum has its terms in the order of the
   * neighbours' numbers, so that the result does not depend on the number of ranks. Collective.
   */
  template <int dim>
  void smooth(const Smoothing<dim> &smoothing, const MPI_Comm &communicator, std::vector<Point<dim>> &points);
} // namespace Lahar

#endif
