// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_point_lists_h
#define lahar_geometry_point_lists_h

#include <deal.II/base/point.h>

#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The points of the text "x, y : x, y : ..." (three coordinates in 3D), a part of @p entry. @throws InputError that
   * says what is @p allowed.
   */
  template <int dim>
  std::vector<Point<dim>> parse_points(const Parameters &prm, const std::string &entry,
                                       const std::string &text, const std::string &allowed);

  /// The lists of points 'x, y : x, y : ...' that @p entry holds, separated by ';'. @throws InputError
  template <int dim>
  std::vector<std::vector<Point<dim>>> parse_point_lists(const Parameters &prm, const std::string &entry);

  /// Points with a name.
  template <int dim>
  struct NamedPoints
  {
    std::string name;
    std::vector<Point<dim>> points;
  };

  /// Read the entry "name: x, y; ..." or, with @p n_points = 2, "name: x, y : x, y; ...". @throws InputError
  template <int dim>
  std::vector<NamedPoints<dim>> parse_named_points(const Parameters &prm, const std::string &entry,
                                                   const unsigned int n_points);
} // namespace Lahar

#endif
