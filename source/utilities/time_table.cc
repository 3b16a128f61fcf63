// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/number_table.h>
#include <lahar/utilities/time_table.h>

#include <algorithm>

namespace Lahar
{
  TimeTable::TimeTable(const std::string &file_name, const std::vector<std::string> &columns)
  {
    std::vector<std::string> all_columns = {"time (s)"};
    all_columns.insert(all_columns.end(), columns.begin(), columns.end());
    const NumberTable table(file_name, all_columns);
    if (table.rows().empty())
      table.throw_wrong_table("has no line with numbers", "at least one");
    for (unsigned int i = 0; i < table.rows().size(); ++i)
    {
      const NumberTable::Row &row = table.rows()[i];
      if (i > 0 && !(row[0] > times.back()))
        table.throw_wrong_row(i, "a time after that of the row before");
      times.push_back(row[0]);
      values.emplace_back(row.begin() + 1, row.end());
    }
  }



  std::vector<double> TimeTable::operator()(const double time) const
  {
    const auto next = std::upper_bound(times.begin(), times.end(), time);
    if (next == times.begin())
      return values.front();
    if (next == times.end())
      return values.back();
    const unsigned int i       = next - times.begin();
    const double part          = (time - times[i - 1]) / (times[i] - times[i - 1]);
    std::vector<double> result = values[i - 1];
    for (unsigned int c = 0; c < result.size(); ++c)
      result[c] += part * (values[i][c] - values[i - 1][c]);
    return result;
  }



  std::vector<double> TimeTable::mean(const double start, const double length) const
  {
    if (length == 0.)
      return (*this)(start);
    // The rule of the trapezium from row to row.
    std::vector<double> places(1, start);
    for (const double time : times)
      if (time > start && time < start + length)
        places.push_back(time);
    places.push_back(start + length);
    std::vector<double> result(values.front().size(), 0.);
    for (unsigned int i = 1; i < places.size(); ++i)
    {
      const std::vector<double> before = (*this)(places[i - 1]), after = (*this)(places[i]);
      for (unsigned int c = 0; c < result.size(); ++c)
        result[c] += 0.5 * (places[i] - places[i - 1]) / length * (before[c] + after[c]);
    }
    return result;
  }
} // namespace Lahar
