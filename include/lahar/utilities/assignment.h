// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_assignment_h
#define lahar_utilities_assignment_h

#include <string>
#include <string_view>
#include <vector>

namespace Lahar
{
  /// One "set entry = value" of the user's, or a "subsection" that he opens.
  struct Assignment
  {
    std::vector<std::string> sections; ///< around the entry, from the outside
    std::string entry;                 ///< empty where a subsection opens
    std::string value;
    std::string place;     ///< how messages call it: "case.prm:12", "Option --set"
    std::string directory; ///< where relative names of files start

    /// As in "Fluid/Bingham/Density".
    std::string path() const;

    /// The absolute name of a file that the value calls @p name.
    std::string absolute_name(const std::string &name) const;

    /// For MPI.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &sections &entry &value &place &directory;
    }
  };

  /**
   * What a parameter file and those that it includes assign, in their order.
   *
   * A line is "subsection name", "end", "set entry = value" or "include file"; "#" begins a comment; a line that ends
   * with "\" goes on in the next one. The text is UTF-8, with or without a byte order mark; lines end with LF or CRLF.
   * The name of an included file is relative to the file that names it. Every subsection ends in its file. Each file is
   * read once from its begin to its end, so that it may be a pipe; all together have at most 10 MB.
   * @throws InputError with file and line for anything else.
   */
  std::vector<Assignment> read_parameter_file(const std::string &file_name);

  /// "Section/Subsection/Entry=value" of the command line, on one or more lines. @throws InputError.
  Assignment parse_override(std::string text);

  /// Text of the user's in quotes: short, without control characters.
  std::string in_quotes(const std::string_view text, const std::size_t longest = 60);

  /// The one of @p names that is most like @p name, a path as "Section/Entry": by the letters to change in all or, if
  /// that is less, in what stands behind the last "/". Empty if none is like it.
  std::string nearest_name(const std::string &name, const std::vector<std::string> &names);
} // namespace Lahar

#endif
