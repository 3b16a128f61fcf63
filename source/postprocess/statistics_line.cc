// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/statistics_line.h>

#include <iomanip>
#include <sstream>

namespace Lahar
{
  namespace
  {
    constexpr unsigned int width_of_reals = 16, width_of_counts = 7;

    /// The table as deal.II writes it: the header's lines begin with '#'.
    std::istringstream text_of(const TableHandler &table)
    {
      std::ostringstream text;
      table.write_text(text, TableHandler::table_with_separate_column_description);
      return std::istringstream(text.str());
    }
  } // namespace



  std::string statistics_line(const TableHandler &table)
  {
    std::istringstream text = text_of(table);
    std::string row;
    while (text.peek() == '#')
      std::getline(text, row);
    std::ostringstream line;
    for (std::string word, separator; text >> word; separator = " ")
    {
      const bool is_count = word.find_first_not_of("-0123456789") == std::string::npos;
      line << separator << std::setw(is_count ? width_of_counts : width_of_reals) << word;
    }
    line << '\n';
    return line.str();
  }



  std::string statistics_header(const TableHandler &table)
  {
    std::istringstream text = text_of(table);
    std::string header, line;
    while (text.peek() == '#' && std::getline(text, line))
      header += line + '\n';
    return header;
  }
} // namespace Lahar
