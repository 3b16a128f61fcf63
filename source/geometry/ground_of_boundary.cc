// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/ground_of_boundary.h>

#include <algorithm>
#include <array>
#include <map>

namespace Lahar
{
  InGroundOfBoundary::InGroundOfBoundary(Parameters &prm, const std::string &entry)
    : prm(prm)
  {
    const std::string name   = prm.get(entry);
    const std::string before = "Boundaries/", behind = "/Shape";
    std::string names;
    bool found = false;
    for (const auto &[path, value] : prm.values())
      if (value == "terrain" && path.size() > before.size() + behind.size() && path.rfind(before, 0) == 0 &&
          path.compare(path.size() - behind.size(), behind.size(), behind) == 0)
      {
        const std::string known = path.substr(before.size(), path.size() - before.size() - behind.size());
        names += (names.empty() ? "'" : ", '") + known + "'";
        found = found || known == name;
      }
    if (!found)
      prm.throw_wrong_value(entry, "a boundary whose 'Shape' is 'terrain': " +
                                     (names.empty() ? "there is none" : names));
    for (const std::string &section : split_list(prm.path(""), '/'))
      if (!section.empty())
        here.push_back(section);
    for (unsigned int i = 0; i < here.size(); ++i)
      prm.leave_subsection();
    prm.enter_subsection("Boundaries");
    prm.enter_subsection(name);
    prm.enter_subsection("terrain");
  }



  InGroundOfBoundary::~InGroundOfBoundary()
  {
    for (unsigned int i = 0; i < 3; ++i)
      prm.leave_subsection();
    for (const std::string &section : here)
      prm.enter_subsection(section);
  }
} // namespace Lahar
