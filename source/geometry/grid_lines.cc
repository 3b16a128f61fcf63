// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/grid_lines.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Lahar
{
  std::vector<double> grid_lines(const double lower, const double upper, const double spacing,
                                 const std::vector<double> &of_file)
  {
    std::vector<double> result(1, lower);
    if (spacing > 0.)
    {
      const double n = std::max(1., std::round((upper - lower) / spacing));
      for (double i = 1.; i < n && i <= most_grid_lines; ++i)
        result.push_back(lower + i / n * (upper - lower));
    }
    else
      for (unsigned int i = 1; i + 1 < of_file.size(); ++i)
        if (of_file[i] > lower + 0.25 * (of_file[i] - of_file[i - 1]) &&
            of_file[i] < upper - 0.25 * (of_file[i + 1] - of_file[i]))
          result.push_back(of_file[i]);
    result.push_back(upper);
    return result;
  }



  std::vector<std::string> check_grid_spacing(const std::string &name, const double spacing, const double h,
                                              const std::string &entry)
  {
    constexpr double largest_ratio = 1e4;
    std::ostringstream found;
    found << "the ground of " << name << " has grid lines " << spacing << " m apart, and 'Mesh size' is " << h
          << " m";
    if (!(spacing < largest_ratio * h && spacing * largest_ratio > h))
      throw InputError("Wrong scale: " + found.str() + ". Allowed: a grid in metres, and '" + entry +
                       "' about as large as 'Mesh size'.");
    std::vector<std::string> result;
    if (spacing > 100. * h)
      result.push_back("Warning: " + found.str() + ": it is flat over a hundred particles.");
    if (spacing < 0.25 * h)
      result.push_back("Warning: " + found.str() + ": particles do not see what is so small. '" + entry +
                       "' makes the grid coarser.");
    return result;
  }
} // namespace Lahar
