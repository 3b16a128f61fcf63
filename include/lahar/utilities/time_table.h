// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_time_table_h
#define lahar_utilities_time_table_h

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Values over time from a file: lines of a time (s) and a fixed number of values, separated by commas, semicolons or
   * white space. Lines that begin with '#', empty ones and one headline before the numbers do not count. Between the
   * times values are linear; before the first and after the last they stay.
   */
  class TimeTable
  {
  public:
    TimeTable() = default;

    /// @throws InputError with file and line for what is no number, for too few or too many in a line, for times that do
    /// not ascend and for a file without numbers.
    TimeTable(const std::string &file_name, const unsigned int n_values);

    /// The values at @p time (s).
    std::vector<double> operator()(const double time) const;

  private:
    std::vector<double> times;
    std::vector<std::vector<double>> values;
  };
} // namespace Lahar

#endif
