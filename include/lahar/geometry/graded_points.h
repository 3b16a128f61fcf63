// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_graded_points_h
#define lahar_geometry_graded_points_h

#include <lahar/geometry/divided_points.h>

#include <functional>
#include <vector>

namespace Lahar
{
  /// The wanted distance h of neighbouring points as a function of the place, m.
  template <int dim>
  using SizeFunction = std::function<double(const Point<dim> &)>;

  /// Whether a point is wanted.
  template <int dim>
  using PointFilter = std::function<bool(const Point<dim> &)>;

  /// Of the points of the lattice with the given distance of neighbours (m) that pass the filter this rank's share: of
  /// their order the first rank has the beginning, the next one what follows.
  template <int dim>
  using Lattice = std::function<std::vector<Point<dim>>(const double, const PointFilter<dim> &)>;

  /**
   * The points of a @p contour, which all ranks have, and behind them what @p lattice has of each of the sizes
   * @p levels, ascending, where h lies between this level and the next one, and nearer than 0.65 h to no other point:
   * so a region where h is a level is filled with the undisturbed lattice. With one level its lattice is taken as it is.
   * The contour's points have the numbers from 0 on; each rank has the points in its part of space. Collective.
   */
  template <int dim>
  DividedPoints<dim> with_graded_lattice(const std::vector<Point<dim>> &contour, const SizeFunction<dim> &h,
                                         const std::vector<double> &levels, const Lattice<dim> &lattice,
                                         const MPI_Comm &communicator);
} // namespace Lahar

#endif
