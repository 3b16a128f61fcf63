// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/utilities.h>

#include <lahar/utilities/assignment.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/parameters.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <system_error>
#include <utility>

namespace Lahar
{
  namespace
  {
    constexpr unsigned int deepest_include = 20;

    /// Of a parameter file and all that it includes, in bytes.
    constexpr std::size_t largest_input = 10'000'000;

    /// Reads one file, and by others of its kind those that it includes.
    class FileReader
    {
    public:
      /// @param n_bytes is where the bytes are counted that this file and the others have.
      FileReader(const std::string &file_name, const std::string &named_by, const unsigned int depth,
                 std::size_t &n_bytes)
        : file_name(file_name)
        , depth(depth)
        , n_bytes(n_bytes)
      {
        const std::string where = named_by.empty() ? "" : named_by + ": ";
        std::error_code error;
        const auto status = std::filesystem::status(file_name, error);
        // To read another device might never end.
        if (std::filesystem::is_regular_file(status) || std::filesystem::is_fifo(status))
          file.open(file_name, std::ios::binary);
        if (!file.is_open())
          throw InputError(where + "Cannot read the parameter file '" + file_name + "', which " +
                           (!std::filesystem::exists(status)             ? "does not exist"
                            : std::filesystem::is_directory(status)      ? "is a directory"
                            : std::filesystem::is_character_file(status) ? "is a device"
                                                                         : "cannot be opened") +
                           ". Allowed: a file or a pipe with read permission" +
                           (named_by.empty() ? "." : ", relative to the file that names it."));
      }

      void read(std::vector<std::string> &sections, std::vector<Assignment> &result)
      {
        std::string joined;
        bool goes_on = false;
        for (std::string line; get_line(line);)
        {
          ++line_number;
          check_encoding(line);
          joined  = Utilities::trim(goes_on ? joined + Utilities::trim(line) : line);
          goes_on = !joined.empty() && joined.back() == '\\';
          if (goes_on)
            joined.pop_back();
          else
            read_line(joined, sections, result);
        }
        if (goes_on)
          read_line(joined, sections, result);
        if (!opened.empty())
          throw InputError(file_name + ":" + std::to_string(opened.back()) + ": the subsection " +
                           in_quotes(sections.back()) +
                           " has no 'end' in its file. Allowed: an 'end' for each subsection.");
      }

    private:
      [[noreturn]] void fail(const std::string &found, const std::string &allowed) const
      {
        throw InputError(place() + ": found " + found + ". Allowed: " + allowed + ".");
      }

      /// Read a line, with or without its end. @return whether there is one.
      bool get_line(std::string &line)
      {
        line.clear();
        for (char c; file.get(c);)
        {
          if (++n_bytes > largest_input)
            throw InputError(file_name + ": with this file the input is longer than " +
                             std::to_string(largest_input) +
                             " bytes. Allowed: that many in all parameter files together.");
          if (c == '\n')
            return true;
          line += c;
        }
        return !line.empty();
      }

      std::string place() const
      {
        return file_name + ":" + std::to_string(line_number);
      }

      /// Drop a byte order mark; refuse what is not UTF-8.
      void check_encoding(std::string &line) const
      {
        const auto starts_with = [&line](const char *mark) { return line.rfind(mark, 0) == 0; };
        if (line_number == 1 && starts_with("\xEF\xBB\xBF"))
          line.erase(0, 3);
        else if (line_number == 1 && (starts_with("\xFF\xFE") || starts_with("\xFE\xFF")))
          fail("the byte order mark of UTF-16", "text in UTF-8");
        if (line.find('\0') != std::string::npos)
          fail("a zero byte, as in UTF-16 or in a binary file", "text in UTF-8");
      }

      /// The text behind @p keyword, in small letters or in capitals. @return whether the line begins with it.
      static bool has_keyword(const std::string &line, const std::string &keyword, std::string &rest)
      {
        std::string capitals = keyword;
        for (char &c : capitals)
          c = std::toupper(static_cast<unsigned char>(c));
        const std::size_t n = keyword.size();
        if ((line.compare(0, n, keyword) != 0 && line.compare(0, n, capitals) != 0) ||
            (line.size() > n && line[n] != ' ' && line[n] != '\t'))
          return false;
        rest = Utilities::trim(line.substr(n));
        return true;
      }

      void read_line(std::string line, std::vector<std::string> &sections, std::vector<Assignment> &result)
      {
        line                        = Utilities::trim(line.substr(0, line.find('#')));
        const std::string directory = std::filesystem::path(file_name).parent_path().string();
        std::string rest;
        if (line.empty())
          return;
        if (has_keyword(line, "subsection", rest) && !rest.empty())
        {
          sections.push_back(rest);
          opened.push_back(line_number);
          result.push_back({sections, "", "", place(), directory});
        }
        else if (has_keyword(line, "end", rest) && rest.empty())
        {
          if (opened.empty())
            fail("'end' where no subsection is open", "one 'end' for each subsection, in the same file");
          sections.pop_back();
          opened.pop_back();
        }
        else if (const std::size_t equals = line.find('=');
                 has_keyword(line, "set", rest) && equals != std::string::npos && equals > 3 &&
                 !Utilities::trim(line.substr(3, equals - 3)).empty())
          result.push_back({sections, Utilities::trim(line.substr(3, equals - 3)),
                            Utilities::trim(line.substr(equals + 1)), place(), directory});
        else if (has_keyword(line, "include", rest) && !rest.empty())
        {
          if (depth == deepest_include)
            throw InputError(place() + ": more than " + std::to_string(deepest_include) +
                             " files include each other. Allowed: a file that does not include itself.");
          FileReader((std::filesystem::path(directory) / rest).string(), place(), depth + 1, n_bytes)
            .read(sections, result);
        }
        else
          fail(in_quotes(line), "'subsection name', 'set entry = value', 'end', 'include file' and comments "
                                "behind '#'");
      }

      std::string file_name;
      std::ifstream file;
      unsigned int depth, line_number = 0;
      std::size_t &n_bytes;
      std::vector<unsigned int> opened; ///< the lines of the subsections that are open
    };
  } // namespace



  std::string Assignment::path() const
  {
    std::string result;
    for (const std::string &section : sections)
      result += section + "/";
    return entry.empty() ? result.substr(0, result.size() - 1) : result + entry;
  }



  std::string Assignment::absolute_name(const std::string &name) const
  {
    const std::filesystem::path relative = std::filesystem::path(directory) / name;
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(relative, error);
    return (error ? relative : whole).lexically_normal().string();
  }



  std::vector<Assignment> read_parameter_file(const std::string &file_name)
  {
    std::vector<Assignment> result;
    std::vector<std::string> sections;
    std::size_t n_bytes = 0;
    FileReader(file_name, "", 0, n_bytes).read(sections, result);
    return result;
  }



  Assignment parse_override(std::string text)
  {
    std::replace(text.begin(), text.end(), '\n', ' ');
    const std::size_t equals = text.find('=');
    Assignment result;
    if (equals != std::string::npos)
      result.sections = split_list(text.substr(0, equals), '/');
    if (result.sections.empty() || result.sections.back().empty())
      throw InputError("Option --set is " + in_quotes(text) +
                       ". Allowed: \"Section/Subsection/Entry=value\".");
    result.entry = result.sections.back();
    result.sections.pop_back();
    const std::string value = text.substr(equals + 1);
    result.value            = Utilities::trim(value.substr(0, value.find('#')));
    result.place            = "Option --set";
    return result;
  }



  std::string in_quotes(const std::string_view text, const std::size_t longest)
  {
    std::string result = "'";
    for (const char c : text.substr(0, longest))
      result += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
    return result + (text.size() > longest ? "...'" : "'");
  }



  namespace
  {
    /// How many letters to insert, to drop or to change.
    unsigned int edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0U);
      for (unsigned int i = 0; i < a.size(); ++i)
      {
        unsigned int diagonal = std::exchange(row[0], i + 1);
        for (unsigned int j = 0; j < b.size(); ++j)
          diagonal = std::exchange(row[j + 1],
                                   std::min({row[j] + 1, row[j + 1] + 1, diagonal + (a[i] != b[j])}));
      }
      return row.back();
    }
  } // namespace



  std::string nearest_name(const std::string &name, const std::vector<std::string> &names)
  {
    constexpr std::size_t longest = 200;
    std::string result;
    if (name.size() > longest)
      return result;
    const auto last = [](const std::string &path) { return path.substr(path.rfind('/') + 1); };
    // Less than half of the letters differ.
    std::pair<unsigned int, unsigned int> smallest((last(name).size() + 1) / 2, 0);
    for (const std::string &candidate : names)
    {
      const unsigned int whole = edit_distance(name, candidate);
      const std::pair<unsigned int, unsigned int> distance(
        std::min(whole, 1 + edit_distance(last(name), last(candidate))), whole);
      if (distance < smallest)
      {
        smallest = distance;
        result   = candidate;
      }
    }
    return result;
  }
} // namespace Lahar
