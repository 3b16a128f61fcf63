// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_profile_h
#define lahar_geometry_profile_h

#include <lahar/geometry/box.h>

#include <array>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Ground in the plane: a line with one height over each x, from a table, linear between its rows.
   */
  class Profile
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// Read the handler's current section. @throws InputError
    explicit Profile(const Parameters &prm);

    /// Points of the line by ascending x, in coordinates of the case.
    const std::vector<Point<2>> &points() const
    {
      return line;
    }

    /// The range of x in the coordinates of the table.
    const std::array<double, 2> &window() const
    {
      return range;
    }

    /// What is subtracted from coordinates of the table.
    const Tensor<1, 2> &origin() const
    {
      return shift;
    }

    /// As Terrain::check_scale().
    std::vector<std::string> check_scale(const std::string &name, const double h) const;

  private:
    std::vector<Point<2>> line;
    std::array<double, 2> range;
    Tensor<1, 2> shift;
    std::string spacing_path;
  };

  /// The two numbers 'x0, x1' of an entry with x0 < x1. @throws InputError
  std::array<double, 2> parse_range(const Parameters &prm, const std::string &entry);

  /// The value at @p x, within the table, of a table of numbers over ascending x, linear between its rows.
  double value_at(const std::vector<Point<2>> &table, const double x);
} // namespace Lahar

#endif
