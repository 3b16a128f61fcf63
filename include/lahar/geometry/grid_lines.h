// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_grid_lines_h
#define lahar_geometry_grid_lines_h

#include <string>
#include <vector>

namespace Lahar
{
  /// The most points of a ground in memory.
  constexpr double most_grid_lines = 4e6;

  /// Grid lines of a ground from @p lower to @p upper: @p spacing apart, as far as that divides the length, or if it is zero
  /// those @p of_file between them. Where one of these is near an end the end takes its place.
  std::vector<double> grid_lines(const double lower, const double upper, const double spacing,
                                 const std::vector<double> &of_file);

  /// Warnings if a grid with lines @p spacing apart is far finer or coarser than the mesh size @p h (m). @param name of the
  /// boundary. @param entry that changes the spacing. @throws InputError if it is so by a factor of 10⁴.
  std::vector<std::string> check_grid_spacing(const std::string &name, const double spacing, const double h,
                                              const std::string &entry);
} // namespace Lahar

#endif
