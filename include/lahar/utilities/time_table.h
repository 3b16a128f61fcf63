// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_time_table_h
#define lahar_utilities_time_table_h

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Values over time from a NumberTable, whose rows are a time (s) and some values. Between the times values are linear;
   * before the first and after the last they stay.
   */
  class TimeTable
  {
  public:
    TimeTable() = default;

    /// @param columns what the values are, for messages. @throws InputError as a NumberTable, and for times that do not
    /// ascend.
    TimeTable(const std::string &file_name, const std::vector<std::string> &columns);

    /// The values at @p time (s).
    std::vector<double> operator()(const double time) const;

    /// Their exact means in the @p length s that begin at @p start; with length zero the values at @p start.
    std::vector<double> mean(const double start, const double length) const;

  private:
    std::vector<double> times;
    std::vector<std::vector<double>> values;
  };
} // namespace Lahar

#endif
