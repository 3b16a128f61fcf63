// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_contact_at_start_h
#define lahar_initial_contact_at_start_h

#include <lahar/geometry/walls.h>

#include <cmath>

namespace Lahar
{
  /// What lies nearer to a wall or to a solid than this times h at the start is in contact with it: the fluid reaches
  /// to it.
  constexpr double contact = 0.1;

  /// Whether @p point lies above or below one of the facets, nearer to it than @p distance.
  template <int dim>
  bool is_near(const Walls<dim> &walls, const Point<dim> &point, const double distance)
  {
    for (const unsigned int f : walls.near(point, distance))
      if (std::abs(walls.signed_distance(f, point)) < distance && walls.is_above(f, point, distance))
        return true;
    return false;
  }
} // namespace Lahar

#endif
