// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/case_structure.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/parameters.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace Lahar
{
  namespace
  {
    bool may_stand_in_name(const char c)
    {
      // Bytes above 127 belong to letters in UTF-8.
      return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) > 127 || c == ' ' ||
             c == '-' || c == '_' || c == '.';
    }

    std::vector<std::string> read_names(const Assignment &assignment)
    {
      const std::vector<std::string> names = split_list(assignment.value, ',');
      const auto fail                      = [&](const std::string &found, const std::string &allowed) {
        throw InputError(assignment.place + ": '" + assignment.path() + "' " + found +
                                              ". Allowed: " + allowed + ".");
      };
      constexpr std::size_t longest = 60;
      for (const std::string &name : names)
      {
        if (name.empty() || name.size() > longest ||
            !std::all_of(name.begin(), name.end(), may_stand_in_name))
          fail("has the name " + in_quotes(name),
               "names of letters, digits, blanks and '-_.', at most 60 long, separated by ','");
        if (std::count(names.begin(), names.end(), name) > 1)
          fail("has the name '" + name + "' twice", "each name once");
      }
      return names;
    }
  } // namespace



  CaseStructure::CaseStructure(const std::vector<Assignment> &assignments)
  {
    for (const Assignment &assignment : assignments)
    {
      if (assignment.entry.empty())
        continue; // a subsection opens
      const std::string path = assignment.path();
      if (path == "Dimension")
        dimension = assignment.value == "3" ? 3 : 2;
      else if (path == "Plugins")
      {
        plugins.clear();
        for (const std::string &name : split_list(assignment.value, ';'))
          plugins.push_back(assignment.absolute_name(name));
      }
      else if (path == "Fluids")
        fluids = read_names(assignment);
      else if (path == "Boundaries")
        boundaries = read_names(assignment);
      else if (path == "Solids")
        solids = read_names(assignment);
    }
  }



  void CaseStructure::complete()
  {
    const auto name_one = [](std::vector<std::string> &names, const std::string &example) {
      if (names.empty())
        names.push_back(example);
    };
    name_one(fluids, "fluid");
    name_one(boundaries, "boundary");
    name_one(solids, "solid");
  }
} // namespace Lahar
