// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/assignment.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/number_table.h>
#include <lahar/utilities/parameters.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace Lahar
{
  namespace
  {
    /// Of a table, in bytes.
    constexpr std::uintmax_t largest_file = 10'000'000;

    constexpr const char *byte_order_mark = "\xef\xbb\xbf";

    std::string cause_of(const std::filesystem::file_status &status)
    {
      return !std::filesystem::exists(status)   ? "does not exist"
             : std::filesystem::is_fifo(status) ? "is a pipe"
                                                : "is a directory or a device";
    }
  } // namespace



  NumberTable::NumberTable(const std::string &file_name, const std::vector<std::string> &columns)
    : file_name(file_name)
  {
    // Only regular files: to open a pipe would wait, to read a device might never end.
    std::error_code error;
    const auto status = std::filesystem::status(file_name, error);
    if (!std::filesystem::is_regular_file(status))
      throw_wrong_table(cause_of(status), "a text file of numbers (.csv)");
    if (const std::uintmax_t size = std::filesystem::file_size(file_name, error);
        !error && size > largest_file)
      throw_wrong_table("has " + std::to_string(size) + " bytes", "at most " + std::to_string(largest_file));
    std::ifstream file(file_name);
    if (!file)
      throw_wrong_table("cannot be opened", "a file with read permission");

    std::string allowed = std::to_string(columns.size()) + " numbers separated by ',':";
    for (unsigned int i = 0; i < columns.size(); ++i)
      allowed += (i > 0 ? ", " : " ") + columns[i];
    allowed += "; '#' begins a comment";

    std::string line;
    for (unsigned int number = 1; std::getline(file, line); ++number)
    {
      if (number == 1 && line.rfind(byte_order_mark, 0) == 0)
        line.erase(0, 3);
      const std::string text = Utilities::trim(line.substr(0, line.find('#')));
      if (text.empty())
        continue;
      Row row;
      try
      {
        for (const std::string &word : split_list(text, ','))
          row.push_back(to_number(word));
      }
      catch (const std::invalid_argument &)
      {
        row.clear();
      }
      lines.push_back(text);
      line_numbers.push_back(number);
      all_rows.push_back(row);
      if (row.size() != columns.size())
        throw_wrong_row(all_rows.size() - 1, allowed);
    }
    if (file.bad())
      throw_wrong_table("cannot be read to its end", "a readable file");
  }



  void NumberTable::throw_wrong_row(const unsigned int row, const std::string &allowed) const
  {
    throw InputError(file_name + ":" + std::to_string(line_numbers[row]) + ": found " +
                     in_quotes(lines[row]) + ". Allowed: " + allowed + ".");
  }



  void NumberTable::throw_wrong_table(const std::string &found, const std::string &allowed) const
  {
    throw InputError("Table '" + file_name + "' " + found + ". Allowed: " + allowed + ".");
  }
} // namespace Lahar
