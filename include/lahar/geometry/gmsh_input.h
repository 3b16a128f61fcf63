// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_gmsh_input_h
#define lahar_geometry_gmsh_input_h

#include <array>
#include <fstream>
#include <string>
#include <string_view>

namespace Lahar
{
  /**
   * A gmsh file as lines of words, blank lines passed over; in its binary parts as a row of numbers. Errors,
   * InputError, name the file and the line, from the first binary part on the byte.
   */
  class GmshInput
  {
  public:
    /// Open a mesh file. @throws InputError unless it is a regular file that can be read.
    explicit GmshInput(const std::string &file_name);

    /// Read what stands in section "$MeshFormat".
    void read_format();

    /// 22 for formats 2 to 2.2, 40 and 41.
    unsigned int version() const
    {
      return format;
    }

    bool is_binary_file() const
    {
      return has_binary_parts;
    }

    /// A binary part begins behind the present line, or ends here.
    void set_binary(const bool binary);

    /// @throws InputError with the place, what was @p found and what is @p allowed.
    [[noreturn]] void fail(const std::string &found, const std::string &allowed) const;

    /// Go to the next line. @return false at the end of the file.
    bool advance();

    /// Go to the next line, which must exist and hold @p expected. In a binary part nothing separates the numbers.
    void advance_to(const std::string_view expected);

    /// What is left of the line, without blanks around it.
    std::string_view rest() const;

    /// The next word. @throws InputError if the line has ended; @p expected says what should have come.
    std::string_view word(const std::string_view expected);

    /// The next number, finite and in the range of @p Number: double, int, unsigned int (binary: as an int) or
    /// std::size_t. @throws InputError otherwise.
    template <typename Number>
    Number number(const std::string_view expected);

    /// The same, but for its value nothing is asked.
    template <typename Number>
    void skip(const std::string_view expected);

    /// The tag of a node or of an element.
    std::size_t tag(const std::string_view expected);

    /// A line with nothing but @p n counts, or as many of a binary part.
    template <std::size_t n>
    std::array<std::size_t, n> counts(const std::string_view expected)
    {
      std::array<std::size_t, n> values;
      advance_to(expected);
      for (std::size_t &value : values)
        value = number<std::size_t>(expected);
      end_line();
      return values;
    }

    /// @throws InputError if something is left of the line.
    void end_line() const;

  private:
    [[noreturn]] void fail_at_end(const std::string_view expected) const;

    /// The next @p Binary of a binary part.
    template <typename Binary>
    Binary binary_number(const std::string_view expected);

    std::string file_name;
    std::ifstream file;
    std::string line;
    std::size_t position    = 0;
    std::size_t line_number = 0;
    std::size_t n_bytes     = 0; ///< read so far
    unsigned int format     = 0;
    bool has_binary_parts   = false;
    bool is_binary          = false; ///< what comes next
    bool was_binary         = false;
  };
} // namespace Lahar

#endif
