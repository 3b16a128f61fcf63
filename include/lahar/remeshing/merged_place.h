// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_merged_place_h
#define lahar_remeshing_merged_place_h

#include <deal.II/base/point.h>

#include <array>

namespace Lahar
{
  using namespace dealii;

  /**
   * The place near the middle between a and b, neighbours on a plane free surface or interface, where one particle encloses
   * the same area with the next ones as the two do; with rotational symmetry the same volume.
   *
   * @param chain previous, a, b, next. @param place m.
   * @return whether there is one, not farther than @p farthest (m) from the middle.
   */
  bool find_merged_place(const std::array<Point<2>, 4> &chain, const double farthest, Point<2> &place);
} // namespace Lahar

#endif
