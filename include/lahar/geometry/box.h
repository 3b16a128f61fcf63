// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_box_h
#define lahar_geometry_box_h

#include <deal.II/base/point.h>

#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /// An axis-parallel box; it may be flat.
  template <int dim>
  struct Box
  {
    Box(const Point<dim> &corner, const Point<dim> &opposite_corner);

    Point<dim> lower, upper;

    /// Whether @p point lies in the box enlarged by @p tolerance.
    bool contains(const Point<dim> &point, const double tolerance) const;
  };

  /// Read the entry "x, y : x, y; ..." of opposite corners (three coordinates in 3D). @throws InputError
  template <int dim>
  std::vector<Box<dim>> parse_boxes(const Parameters &prm, const std::string &entry);
} // namespace Lahar

#endif
