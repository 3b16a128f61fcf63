// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/announced_pattern.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  void Parameters::declare_number(const std::string &entry, const std::string &default_value,
                                  const std::string &documentation, const double lower, const double upper)
  {
    declare_entry(entry, default_value, AnnouncedPattern(Patterns::Double(lower, upper)), documentation);
  }



  void Parameters::declare_count(const std::string &entry, const std::string &default_value,
                                 const std::string &documentation, const unsigned int lower,
                                 const unsigned int upper)
  {
    declare_entry(entry, default_value, AnnouncedPattern(Patterns::Integer(lower, upper)), documentation);
  }



  void Parameters::declare_choice(const std::string &entry, const std::string &default_value,
                                  const std::string &choices, const std::string &documentation)
  {
    declare_entry(entry, default_value, AnnouncedPattern(Patterns::Selection(choices)), documentation);
  }



  void Parameters::declare_bool(const std::string &entry, const bool default_value,
                                const std::string &documentation)
  {
    declare_entry(entry, default_value ? "true" : "false", AnnouncedPattern(Patterns::Bool()), documentation);
  }



  void Parameters::declare_vector(const std::string &entry, const std::string &default_value,
                                  const unsigned int n, const std::string &documentation)
  {
    declare_entry(entry, default_value, AnnouncedPattern(Patterns::List(Patterns::Double(), n, n, ",")),
                  documentation);
  }



  void Parameters::declare_list(const std::string &entry, const std::string &default_value,
                                const char separator, const std::string &documentation)
  {
    declare_entry(entry, default_value,
                  AnnouncedPattern(Patterns::List(Patterns::Anything(), 0, Patterns::List::max_int_value,
                                                  std::string(1, separator))),
                  documentation);
  }



  void Parameters::declare_text(const std::string &entry, const std::string &default_value,
                                const std::string &documentation)
  {
    declare_entry(entry, default_value, Patterns::Anything(), documentation);
  }



  void Parameters::declare_file(const std::string &entry, const std::string &documentation)
  {
    declare_entry(entry, "", AnnouncedPattern(Patterns::FileName(Patterns::FileName::input)), documentation);
    files.insert(path(entry));
  }



  void Parameters::declare_file_list(const std::string &entry, const std::string &documentation)
  {
    declare_list(entry, "", ';', documentation);
    file_lists.insert(path(entry));
  }
} // namespace Lahar
