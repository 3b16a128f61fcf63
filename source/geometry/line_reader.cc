// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/line_reader.h>
#include <lahar/utilities/exceptions.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <type_traits>

namespace Lahar
{
  std::string in_quotes(const std::string_view text)
  {
    std::string result = "'";
    for (const char c : text.substr(0, 60))
      result += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
    return result + (text.size() > 60 ? "...'" : "'");
  }



  LineReader::LineReader(const std::string &file_name)
    : file_name(file_name)
  {
    // Only regular files: to open a pipe would wait, to read a device might never end.
    std::error_code error;
    const auto status = std::filesystem::status(file_name, error);
    if (!std::filesystem::is_regular_file(status))
      throw InputError("Mesh file '" + file_name + "' " +
                       (std::filesystem::exists(status) ? "is a directory or a device" : "does not exist") +
                       ". Allowed: a gmsh file (.msh, ASCII).");
    file.open(file_name, std::ios::binary);
    if (!file)
      throw InputError("Mesh file '" + file_name +
                       "' cannot be opened. Allowed: a file with read permission.");
  }



  void LineReader::fail(const std::string &found, const std::string &allowed) const
  {
    throw InputError(file_name + ":" + std::to_string(line_number) + ": found " + found +
                     ". Allowed: " + allowed + ".");
  }



  bool LineReader::advance()
  {
    while (std::getline(file, line))
    {
      ++line_number;
      position = 0;
      if (!rest().empty())
        return true;
    }
    if (file.bad())
      fail("a read error behind this line", "a readable file");
    return false;
  }



  void LineReader::advance_to(const std::string_view expected)
  {
    if (!advance())
      fail("the end of the file",
           std::string(expected) + " (the file is truncated or a count in it too large)");
  }



  std::string_view LineReader::rest() const
  {
    const std::size_t begin = line.find_first_not_of(" \t\r", position);
    if (begin == std::string::npos)
      return {};
    return std::string_view(line).substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
  }



  std::string_view LineReader::word(const std::string_view expected)
  {
    if (rest().empty())
      fail("the end of the line", std::string(expected));
    const std::string_view result = rest().substr(0, rest().find_first_of(" \t\r"));
    position                      = result.data() + result.size() - line.data();
    return result;
  }



  template <typename Number>
  Number LineReader::number(const std::string_view expected)
  {
    const std::string_view text = word(expected);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool valid              = error == std::errc() && end == text.data() + text.size();
    if constexpr (std::is_floating_point_v<Number>)
      valid = valid && std::isfinite(value);
    if (!valid)
      fail(in_quotes(text), std::string(expected) + (std::is_floating_point_v<Number> ? ", a finite number"
                                                     : std::is_signed_v<Number>       ? ", an integer"
                                                                                : ", an integer from 0"));
    return value;
  }



  std::size_t LineReader::count(const std::string_view expected)
  {
    return number<std::size_t>(expected);
  }



  void LineReader::end_line() const
  {
    if (!rest().empty())
      fail(in_quotes(rest()), "the end of the line");
  }



  template int LineReader::number(const std::string_view);
  template double LineReader::number(const std::string_view);
  template unsigned int LineReader::number(const std::string_view);
} // namespace Lahar
