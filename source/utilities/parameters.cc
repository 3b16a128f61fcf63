// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/tensor.h>
#include <deal.II/base/utilities.h>

#include <lahar/utilities/parameters.h>
#include <lahar/utilities/renamed_entries.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace Lahar
{
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



  namespace
  {
    /// The handler keeps entries and subsections in one tree; the blank, which nobody sees, keeps their names apart.
    std::string apart(const std::string &name)
    {
      return name + ' ';
    }
  } // namespace



  void Parameters::declare_names(const std::string &entry, const std::string &documentation)
  {
    declare_list(apart(entry), "", ',', documentation);
    name_lists.insert(path(entry));
  }



  void Parameters::set_names(const std::string &entry, const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : ", ") + name;
    set(apart(entry), text);
  }



  bool Parameters::knows(const Assignment &assignment, const std::map<std::string, std::string> &known) const
  {
    const auto has_slash = [](const std::string &name) { return name.find('/') != std::string::npos; };
    return subsection_path_exists(assignment.sections) && !has_slash(assignment.entry) &&
           std::none_of(assignment.sections.begin(), assignment.sections.end(), has_slash) &&
           (assignment.entry.empty() || known.count(assignment.path()) > 0);
  }



  void Parameters::check_renamed(const std::vector<Assignment> &assignments,
                                 const std::map<std::string, std::string> &known) const
  {
    constexpr unsigned int most_said = 4;
    std::string message;
    std::set<std::string> said;
    // A subsection 'Fluid' of today's form is a slip of the pen, for which the nearest name is told.
    const bool is_slip =
      std::any_of(assignments.begin(), assignments.end(), [&](const Assignment &assignment) {
        const std::string path = assignment.path();
        return path.rfind("Fluid/", 0) == 0 && known.count("Fluids/" + path.substr(6)) > 0;
      });
    // Entries say more than the subsections around them.
    for (const bool is_entry : {true, false})
      for (const Assignment &assignment : assignments)
      {
        const std::string path = assignment.path(), now = new_spelling(path);
        if (is_slip && (path == "Fluid" || path.rfind("Fluid/", 0) == 0))
          continue;
        if (now.empty() || assignment.entry.empty() == is_entry || (!is_entry && !message.empty()) ||
            knows(assignment, known) || !said.insert(path).second || said.size() > most_said)
          continue;
        message += (message.empty() ? "" : "\n") + assignment.place + ": there is no " +
                   (is_entry ? "entry " : "subsection ") + in_quotes(path, 200) +
                   " any more. Allowed: " + now + ".";
      }
    if (said.size() > most_said)
      message += "\nThere are " + std::to_string(said.size() - most_said) + " more such entries.";
    if (!message.empty())
      throw InputError(message +
                       "\n'contrib/utilities/convert-case' writes an older parameter file in the new form.");
  }



  void Parameters::assign(const std::vector<Assignment> &assignments, const Parameters &of_other_dimension)
  {
    const std::map<std::string, std::string> known = values();
    check_renamed(assignments, known);
    // Messages say which names there are in the end.
    for (const Assignment &assignment : assignments)
      if (!assignment.entry.empty() && name_lists.count(assignment.path()) > 0)
        set(apart(assignment.entry), assignment.value);
    for (const Assignment &assignment : assignments)
    {
      const std::string entry_path = assignment.path();
      if (!knows(assignment, known))
        throw_unknown(assignment, of_other_dimension);
      if (assignment.entry.empty() || name_lists.count(entry_path) > 0)
        continue;
      std::string value = assignment.value;
      if (is_file(entry_path) && !value.empty())
        value = assignment.absolute_name(value);
      else if (file_lists.count(entry_path) > 0)
      {
        value.clear();
        for (const std::string &name : split_list(assignment.value, ';'))
          value += (value.empty() ? "" : " ; ") + assignment.absolute_name(name);
      }
      for (const std::string &section : assignment.sections)
        enter_subsection(section);
      set(assignment.entry, value);
      for (unsigned int i = 0; i < assignment.sections.size(); ++i)
        leave_subsection();
    }
  }



  void Parameters::throw_unknown(const Assignment &assignment, const Parameters &of_other_dimension) const
  {
    const bool is_entry = !assignment.entry.empty();
    const auto paths    = [is_entry](const Parameters &prm) {
      std::set<std::string> result;
      for (const auto &[path, value] : prm.values())
        for (std::size_t end = path.size(); end != std::string::npos && end > 0;
             end             = path.rfind('/', end - 1))
          if (is_entry == (end == path.size()))
            result.insert(path.substr(0, end));
      return result;
    };
    const std::set<std::string> here = paths(*this);
    const std::string path           = assignment.path();
    std::string message = assignment.place + ": there is no " + (is_entry ? "entry " : "subsection ") +
                          in_quotes(path, 200);
    const std::vector<std::string> &sections_of_it = assignment.sections;
    if (sections_of_it.size() > 1 && name_lists.count(sections_of_it[0]) > 0 &&
        !subsection_path_exists({sections_of_it[0], sections_of_it[1]}))
      throw InputError(message + ", as '" + sections_of_it[1] + "' is not in 'set " + sections_of_it[0] +
                       " = " + get(apart(sections_of_it[0])) + "'. Allowed: the names there.");
    if (paths(of_other_dimension).count(path) > 0)
      message += " where 'Dimension' is " + get("Dimension") +
                 ". Allowed: 'set Dimension = " + of_other_dimension.get("Dimension") + "' for it, or";
    else
    {
      constexpr std::size_t few = 12;
      const std::string section = path.substr(0, path.rfind('/') + 1);
      std::vector<std::string> beside, below;
      for (const std::string &other : here)
        if (!section.empty() && other.rfind(section, 0) == 0)
          (other.find('/', section.size()) == std::string::npos ? beside : below).push_back(other);
      std::string nearest = nearest_name(path, beside);
      if (nearest.empty())
        nearest = nearest_name(path, below);
      if (nearest.empty() && !beside.empty() && beside.size() <= few)
      {
        message += ". Allowed in '" + section.substr(0, section.size() - 1) + "':";
        for (const std::string &other : beside)
          message += (other == beside.front() ? " '" : ", '") + other.substr(section.size()) + "'";
        throw InputError(message + ".");
      }
      if (nearest.empty())
        nearest = nearest_name(path, {here.begin(), here.end()});
      message += nearest.empty() ? ". Allowed:" : "; the nearest is '" + nearest + "'. Allowed:";
    }
    throw InputError(message + " what 'lahar --print-parameters prm' prints.");
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



  std::optional<double> Parameters::get_number_or(const std::string &entry, const std::string &word) const
  {
    if (get(entry) == word)
      return {};
    try
    {
      return to_number(get(entry));
    }
    catch (const std::invalid_argument &)
    {
      throw_wrong_value(entry, "a finite number or '" + word + "'");
    }
  }



  std::optional<double> Parameters::get_positive_or(const std::string &entry, const std::string &word) const
  {
    if (get(entry) == word)
      return {};
    try
    {
      if (const double value = to_number(get(entry)); value > 0.)
        return value;
    }
    catch (const std::invalid_argument &)
    {}
    throw_wrong_value(entry, "a finite number above zero or '" + word + "'");
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
    if (components.size() == 5 - dim)
      throw_wrong_value(entry, std::to_string(dim) + " numbers separated by commas, since 'Dimension' is " +
                                 std::to_string(dim));
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



  std::vector<std::string> Parameters::get_names(const std::string &entry) const
  {
    const std::string text = get(entry);
    std::vector<std::string> names;
    for (std::size_t begin = 0, end; begin < text.size(); begin = end + 1)
    {
      begin              = std::min(text.find_first_not_of(" \t", begin), text.size());
      const bool quoted  = text[begin] == '"';
      const auto closing = quoted ? text.find('"', begin + 1) : begin;
      end                = std::min(text.find(',', closing), text.size());
      if (closing == std::string::npos || (quoted && text.find_first_not_of(" \t", closing + 1) < end))
        throw_wrong_value(entry, "names separated by commas, those with a comma in double quotes");
      names.push_back(quoted ? text.substr(begin + 1, closing - begin - 1)
                             : Utilities::trim(text.substr(begin, end - begin)));
    }
    return names;
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
