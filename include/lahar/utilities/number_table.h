// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_number_table_h
#define lahar_utilities_number_table_h

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * A text file (CSV) with some finite numbers in every line, separated by ','. What follows '#' is a comment, lines
   * without numbers do not count, a byte order mark and line ends of Windows are allowed. A pipe is not.
   */
  class NumberTable
  {
  public:
    using Row = std::vector<double>;

    /// @param columns what the numbers of a line are, for messages.
    /// @throws InputError with the name of the file and, where there is one, the line.
    NumberTable(const std::string &file_name, const std::vector<std::string> &columns);

    const std::vector<Row> &rows() const
    {
      return all_rows;
    }

    /// Throw InputError about the row with the file's name, the line and what it says.
    [[noreturn]] void throw_wrong_row(const unsigned int row, const std::string &allowed) const;

    /// Throw InputError about the table as a whole.
    [[noreturn]] void throw_wrong_table(const std::string &found, const std::string &allowed) const;

  private:
    std::string file_name;
    std::vector<Row> all_rows;
    std::vector<unsigned int> line_numbers; ///< of the rows, from 1
    std::vector<std::string> lines;         ///< of the rows, as they stand in the file
  };
} // namespace Lahar

#endif
