// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/tensor.h>
#include <deal.II/base/utilities.h>

#include <lahar/utilities/parameters.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Lahar
{
  void Parameters::parse_input(std::istream &input, const std::string &file_name,
                               const std::string &last_line, const bool skip_undefined)
  {
    // deal.II calls this function for the file that a line "include file" names.
    constexpr unsigned int deepest = 20;
    if (depth == deepest)
      throw InputError("Parameter file: more than " + std::to_string(deepest) +
                       " files include each other. Allowed: a file that does not include itself.");
    if (depth == 0)
      skip_unknown = skip_undefined;
    ++depth;
    try
    {
      ParameterHandler::parse_input(input, file_name, last_line, skip_unknown);
    }
    catch (...)
    {
      --depth;
      throw;
    }
    --depth;
  }



  void Parameters::enter_subsection(const std::string &name)
  {
    ParameterHandler::enter_subsection(name);
    sections.push_back(name);
  }



  void Parameters::leave_subsection()
  {
    ParameterHandler::leave_subsection();
    sections.pop_back();
  }



  std::string Parameters::path(const std::string &entry) const
  {
    std::string result;
    for (const std::string &section : sections)
      result += section + "/";
    return result + entry;
  }



  void Parameters::throw_wrong_value(const std::string &entry, const std::string &allowed) const
  {
    const auto shortened = [](const std::string &text) {
      constexpr std::size_t longest = 1000;
      return text.size() > longest ? text.substr(0, longest) + "..." : text;
    };
    throw InputError("Parameter '" + path(entry) + "' is '" + shortened(get(entry)) +
                     "'. Allowed: " + shortened(allowed) + ".");
  }



  double Parameters::get_number(const std::string &entry) const
  {
    try
    {
      return to_number(get(entry));
    }
    catch (const std::invalid_argument &)
    {
      throw_wrong_value(entry, "a finite number");
    }
  }



  double Parameters::get_positive(const std::string &entry, const bool allow_zero) const
  {
    const double value = get_number(entry);
    if (value < 0. || (value == 0. && !allow_zero))
      throw_wrong_value(entry, allow_zero ? "a finite number, zero or above" : "a finite number above zero");
    return value;
  }



  double Parameters::get_in_range(const std::string &entry, const double lower, const double upper) const
  {
    const double value = get_number(entry);
    if (!(value >= lower && value <= upper))
      throw_wrong_value(entry, "a number from " + Utilities::to_string(lower) + " to " +
                                 Utilities::to_string(upper));
    return value;
  }



  unsigned int Parameters::get_count(const std::string &entry, const unsigned int lower,
                                     const unsigned int upper) const
  {
    const double value = get_number(entry);
    if (!(value >= lower && value <= upper) || value != std::floor(value))
      throw_wrong_value(entry,
                        "a whole number from " + std::to_string(lower) + " to " + std::to_string(upper));
    return static_cast<unsigned int>(value);
  }



  template <int dim>
  Tensor<1, dim> Parameters::get_vector(const std::string &entry) const
  {
    const std::vector<std::string> components = split_list(get(entry), ',');
    if (components.size() != dim)
      throw_wrong_value(entry, std::to_string(dim) + " numbers separated by commas");
    Tensor<1, dim> vector;
    try
    {
      for (unsigned int d = 0; d < dim; ++d)
        vector[d] = to_number(components[d]);
    }
    catch (const std::invalid_argument &)
    {
      throw_wrong_value(entry, std::to_string(dim) + " numbers separated by commas");
    }
    return vector;
  }



  std::map<std::string, std::string> Parameters::values() const
  {
    std::stringstream text;
    print_parameters(text, ParameterHandler::ShortPRM);
    std::map<std::string, std::string> result;
    std::string path;
    for (std::string line; std::getline(text, line);)
    {
      line = Utilities::trim(line);
      if (line.rfind("subsection ", 0) == 0)
        path += line.substr(11) + "/";
      else if (line == "end")
        path.erase(path.find_last_of('/', path.size() - 2) + 1);
      else if (line.rfind("set ", 0) == 0)
      {
        const std::size_t equals                                   = line.find('=');
        result[path + Utilities::trim(line.substr(4, equals - 4))] = Utilities::trim(line.substr(equals + 1));
      }
    }
    return result;
  }



  std::vector<std::string> split_list(const std::string &text, const char separator)
  {
    if (Utilities::trim(text).empty())
      return {};
    std::vector<std::string> pieces;
    std::size_t begin = 0;
    while (true)
    {
      const std::size_t end = text.find(separator, begin);
      pieces.push_back(Utilities::trim(text.substr(begin, end == std::string::npos ? end : end - begin)));
      if (end == std::string::npos)
        return pieces;
      begin = end + 1;
    }
  }



  double to_number(const std::string &text)
  {
    std::size_t used = 0;
    double number    = 0.;
    try
    {
      number = std::stod(text, &used);
    }
    catch (const std::out_of_range &)
    {
      throw std::invalid_argument(text);
    }
    if (used != text.size() || !std::isfinite(number))
      throw std::invalid_argument(text);
    return number;
  }



  template Tensor<1, 2> Parameters::get_vector<2>(const std::string &) const;
  template Tensor<1, 3> Parameters::get_vector<3>(const std::string &) const;
} // namespace Lahar
