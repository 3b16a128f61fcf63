// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_axis_h
#define lahar_initial_axis_h

#include <lahar/initial/boundary.h>

namespace Lahar
{
  /// The name of the boundary that make_axis() makes.
  constexpr char axis_name[] = "axis";

  /**
   * The axis x = 0 of rotational symmetry as a boundary along which fluid slides. It reaches beyond @p points, those of the
   * fluids and of all boundaries, by a hundred times their extent.
   */
  Boundary<2> make_axis(Parameters &prm, const std::vector<Point<2>> &points);

  /**
   * Refuse what rotational symmetry makes no sense of: walls at x < 0 or along the axis, a boundary of its name, fluid that
   * comes in or leaves, boundaries whose motion between @p start_time and @p end_time (s) is no translation along the axis.
   * @throws InputError
   */
  void check_boundary_about_axis(const Boundary<2> &boundary, const double start_time, const double end_time);
} // namespace Lahar

#endif
