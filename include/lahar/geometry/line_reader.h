// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_line_reader_h
#define lahar_geometry_line_reader_h

#include <fstream>
#include <string>
#include <string_view>

namespace Lahar
{
  /// Text of a file in quotes, short and printable.
  std::string in_quotes(const std::string_view text);

  /// A text file as lines of words; its errors, InputError, name file and line. Blank lines are passed over.
  class LineReader
  {
  public:
    /// Open a mesh file. @throws InputError unless it is a regular file that can be read.
    explicit LineReader(const std::string &file_name);

    /// @throws InputError with file and line, what was @p found and what is @p allowed.
    [[noreturn]] void fail(const std::string &found, const std::string &allowed) const;

    /// Go to the next line. @return false at the end of the file.
    bool advance();

    /// Go to the next line, which must exist and hold @p expected.
    void advance_to(const std::string_view expected);

    /// What is left of the line, without blanks around it.
    std::string_view rest() const;

    /// The next word. @throws InputError if the line has ended; @p expected says what should have come.
    std::string_view word(const std::string_view expected);

    /// The next word as a number that is finite and fits into @p Number: double, int or unsigned int.
    /// @throws InputError otherwise.
    template <typename Number>
    Number number(const std::string_view expected);

    /// The next word as a number from 0 on. @throws InputError otherwise.
    std::size_t count(const std::string_view expected);

    /// @throws InputError if something is left of the line.
    void end_line() const;

  private:
    std::string file_name;
    std::ifstream file;
    std::string line;
    std::size_t position    = 0;
    std::size_t line_number = 0;
  };
} // namespace Lahar

#endif
