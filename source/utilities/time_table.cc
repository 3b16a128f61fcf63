// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/parameters.h>
#include <lahar/utilities/time_table.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace Lahar
{
  TimeTable::TimeTable(const std::string &file_name, const unsigned int n_values)
  {
    std::ifstream file(file_name);
    if (!file)
      throw InputError("File '" + file_name + "' cannot be read. Allowed: a table of times and values.");
    unsigned int n_lines = 0;
    bool has_headline    = false;
    for (std::string line; std::getline(file, line);)
    {
      ++n_lines;
      std::replace_if(
        line.begin(), line.end(), [](const char c) { return c == ',' || c == ';' || c == '\r'; }, ' ');
      std::istringstream words(line);
      std::vector<double> numbers;
      std::string word;
      const auto fail = [&](const std::string &what) {
        throw InputError(file_name + ":" + std::to_string(n_lines) + ": " + what +
                         " Allowed: lines of a time in s and " + std::to_string(n_values) +
                         " values, separated by commas, with times that ascend.");
      };
      bool is_headline = false;
      while (words >> word && !is_headline)
      {
        if (word[0] == '#')
          break;
        try
        {
          numbers.push_back(to_number(word));
        }
        catch (const std::invalid_argument &)
        {
          if (!times.empty() || has_headline || !numbers.empty())
            fail("'" + word.substr(0, 40) + "' is not a number.");
          is_headline = true;
        }
      }
      has_headline = has_headline || is_headline;
      if (is_headline || numbers.empty())
        continue;
      if (numbers.size() != n_values + 1)
        fail("there are " + std::to_string(numbers.size()) + " numbers instead of " +
             std::to_string(n_values + 1) + ".");
      if (!times.empty() && numbers[0] <= times.back())
        fail("the time " + std::to_string(numbers[0]) + " s comes after " + std::to_string(times.back()) +
             " s.");
      times.push_back(numbers[0]);
      values.emplace_back(numbers.begin() + 1, numbers.end());
    }
    if (times.empty())
      throw InputError(file_name + ": there are no numbers. Allowed: lines of a time in s and " +
                       std::to_string(n_values) + " values, separated by commas.");
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
} // namespace Lahar
