// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_input.h>
#include <lahar/utilities/assignment.h>
#include <lahar/utilities/exceptions.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <system_error>
#include <type_traits>

namespace Lahar
{
  namespace
  {
    /// Of a mesh file, in bytes: some ten million elements.
    constexpr std::uintmax_t largest_file = 500'000'000;
  } // namespace



  GmshInput::GmshInput(const std::string &file_name)
    : file_name(file_name)
  {
    // Only regular files: to open a pipe would wait, to read a device might never end.
    std::error_code error;
    const auto status = std::filesystem::status(file_name, error);
    if (!std::filesystem::is_regular_file(status))
      throw InputError("Mesh file '" + file_name + "' " +
                       (!std::filesystem::exists(status)   ? "does not exist"
                        : std::filesystem::is_fifo(status) ? "is a pipe"
                                                           : "is a directory or a device") +
                       ". Allowed: a gmsh file (.msh).");
    if (const std::uintmax_t size = std::filesystem::file_size(file_name, error);
        !error && size > largest_file)
      throw InputError("Mesh file '" + file_name + "' has " + std::to_string(size) +
                       " bytes. Allowed: " + std::to_string(largest_file) + ".");
    file.open(file_name, std::ios::binary);
    if (!file)
      throw InputError("Mesh file '" + file_name +
                       "' cannot be opened. Allowed: a file with read permission.");
  }



  void GmshInput::read_format()
  {
    static const std::map<std::string, unsigned int, std::less<>> formats = {{"2", 22},   {"2.0", 22},
                                                                             {"2.1", 22}, {"2.2", 22},
                                                                             {"4", 40},   {"4.0", 40},
                                                                             {"4.1", 41}};
    advance_to("version, file type and data size");
    const std::string_view text = word("the version, 2.2, 4.0 or 4.1");
    const auto found            = formats.find(text);
    if (found == formats.end())
      fail("file format " + in_quotes(text), "2.2, 4.0 and 4.1 (gmsh -format msh41)");
    format          = found->second;
    const auto type = number<unsigned int>("the file type, 0 or 1");
    if (type > 1)
      fail("file type " + std::to_string(type), "0 (ASCII) and 1 (binary)");
    const auto size = number<std::size_t>("the data size");
    end_line();
    has_binary_parts = type == 1;
    if (!has_binary_parts)
      return;
    if (format == 40)
      fail("a binary file of format 4.0", "format 4.1 (gmsh -bin -format msh41) or ASCII, as in gmsh");
    if (size != sizeof(double))
      fail("a binary file with the data size " + std::to_string(size), std::to_string(sizeof(double)));
    set_binary(true);
    if (number<int>("the number 1, which shows the order of bytes") != 1)
      fail("a binary file of another order of bytes", "one of a machine of this kind, or ASCII");
    set_binary(false);
  }



  void GmshInput::set_binary(const bool binary)
  {
    is_binary  = binary;
    was_binary = was_binary || binary;
    position   = line.size();
  }



  void GmshInput::fail(const std::string &found, const std::string &allowed) const
  {
    throw InputError(file_name + ":" +
                     (was_binary ? "byte " + std::to_string(n_bytes) : std::to_string(line_number)) +
                     ": found " + found + ". Allowed: " + allowed + ".");
  }



  void GmshInput::fail_at_end(const std::string_view expected) const
  {
    fail("the end of the file",
         std::string(expected) + " (the file is truncated or a count in it too large)");
  }



  bool GmshInput::advance()
  {
    while (std::getline(file, line))
    {
      ++line_number;
      n_bytes += line.size() + 1;
      position = 0;
      if (!rest().empty())
        return true;
    }
    if (file.bad())
      fail("a read error behind this line", "a readable file");
    return false;
  }



  void GmshInput::advance_to(const std::string_view expected)
  {
    if (!is_binary && !advance())
      fail_at_end(expected);
  }



  std::string_view GmshInput::rest() const
  {
    const std::size_t begin = line.find_first_not_of(" \t\r", position);
    if (begin == std::string::npos)
      return {};
    return std::string_view(line).substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
  }



  std::string_view GmshInput::word(const std::string_view expected)
  {
    if (rest().empty())
      fail("the end of the line", std::string(expected));
    const std::string_view result = rest().substr(0, rest().find_first_of(" \t\r"));
    position                      = result.data() + result.size() - line.data();
    return result;
  }



  template <typename Binary>
  Binary GmshInput::binary_number(const std::string_view expected)
  {
    std::array<char, sizeof(Binary)> bytes;
    if (!file.read(bytes.data(), bytes.size()))
      fail_at_end(expected);
    n_bytes += bytes.size();
    Binary value;
    std::memcpy(&value, bytes.data(), bytes.size());
    return value;
  }



  template <typename Number>
  Number GmshInput::number(const std::string_view expected)
  {
    Number value{};
    bool valid;
    std::string found;
    if (is_binary)
    {
      using Binary        = std::conditional_t<std::is_same_v<Number, unsigned int>, int, Number>;
      const Binary binary = binary_number<Binary>(expected);
      value               = binary;
      valid               = std::is_same_v<Binary, Number> || binary >= 0;
      found               = std::to_string(binary);
    }
    else
    {
      const std::string_view text = word(expected);
      const auto [end, error]     = std::from_chars(text.data(), text.data() + text.size(), value);
      valid                       = error == std::errc() && end == text.data() + text.size();
      found                       = text;
    }
    if constexpr (std::is_floating_point_v<Number>)
      valid = valid && std::isfinite(value);
    if (!valid)
      fail(in_quotes(found), std::string(expected) + (std::is_floating_point_v<Number> ? ", a finite number"
                                                      : std::is_signed_v<Number>       ? ", an integer"
                                                                                 : ", an integer from 0"));
    return value;
  }



  template <typename Number>
  void GmshInput::skip(const std::string_view expected)
  {
    if (is_binary)
      binary_number<Number>(expected);
    else
      word(expected);
  }



  std::size_t GmshInput::tag(const std::string_view expected)
  {
    return format == 41 ? number<std::size_t>(expected) : number<unsigned int>(expected);
  }



  void GmshInput::end_line() const
  {
    if (!is_binary && !rest().empty())
      fail(in_quotes(rest()), "the end of the line");
  }



  template int GmshInput::number(const std::string_view);
  template double GmshInput::number(const std::string_view);
  template unsigned int GmshInput::number(const std::string_view);
  template std::size_t GmshInput::number(const std::string_view);
  template void GmshInput::skip<int>(const std::string_view);
  template void GmshInput::skip<double>(const std::string_view);
} // namespace Lahar
