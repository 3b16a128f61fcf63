// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/renamed_entries.h>

#include <cctype>
#include <map>

namespace Lahar
{
  namespace
  {
    std::string part(const std::string &kind, const std::string &shape, const std::string &entry)
    {
      return "'" + kind + "/NAME/" + shape + "/" + entry + "' with 'set " + kind + " = NAME' and '" + kind +
             "/NAME/Shape = " + shape + "'";
    }

    std::string wall(const std::string &shape, const std::string &entry, const std::string &law)
    {
      return part("Boundaries", shape, entry) + " and 'Boundaries/NAME/Law = " + law + "'";
    }

    const std::map<std::string, std::string> &renamed()
    {
      static const std::map<std::string, std::string> all = {
        {"Geometry", "the subsections 'Fluids' and 'Boundaries'"},
        {"Geometry/Fluid boxes", part("Fluids", "box", "Corners")},
        {"Geometry/Fluid polygons", part("Fluids", "polygon", "Corners")},
        {"Geometry/Fluid polyhedra", part("Fluids", "convex", "Corners")},
        {"Geometry/Fluid cones",
         part("Fluids", "cone", "Base") + ", 'Base radius', 'Top radius' and 'Height'"},
        {"Geometry/Fluid cylinders", part("Fluids", "cylinder", "Ends") + " and 'Radius'"},
        {"Geometry/Fluid groups", part("Fluids", "mesh", "Groups")},
        {"Geometry/No-slip walls", wall("polyline", "Points", "no slip") + ", in space 'polygon/Corners'"},
        {"Geometry/Slip walls", wall("polyline", "Points", "free slip") + ", in space 'polygon/Corners'"},
        {"Geometry/No-slip wall groups", wall("mesh", "Groups", "no slip")},
        {"Geometry/Slip wall groups", wall("mesh", "Groups", "free slip")},
        {"Geometry/Mesh file",
         "'mesh/File' of each part in 'Fluids' and 'Boundaries' whose 'Shape' is 'mesh'"},
        {"Geometry/Mesh scale",
         "'mesh/Scale' of each part in 'Fluids' and 'Boundaries' whose 'Shape' is 'mesh'"},
        {"Geometry/Largest number of particles", "'Largest number of particles'"},
        {"Initial velocity", "'Fluids/NAME/Initial velocity'"},
        {"Fluid", "'Fluids/NAME' with 'set Fluids = NAME'"},
        {"Solids/Number of solids", "'set Solids = NAME, ...' with a subsection 'Solids/NAME' for each"},
      };
      return all;
    }

    const std::map<std::string, std::string> &renamed_of_solid()
    {
      static const std::map<std::string, std::string> all = {{"Box", "box/Corners"},
                                                             {"Elements", "box/Elements"},
                                                             {"Mesh file", "mesh/File"},
                                                             {"Mesh scale", "mesh/Scale"},
                                                             {"Group", "mesh/Groups"}};
      return all;
    }
  } // namespace



  std::string new_spelling(const std::string &path)
  {
    if (const auto found = renamed().find(path); found != renamed().end())
      return found->second;
    if (path.rfind("Fluid/", 0) == 0)
      return "'Fluids/NAME/" + path.substr(6) + "' with 'set Fluids = NAME'";
    if (const std::string solid = "Solids/Solid "; path.rfind(solid, 0) == 0)
    {
      std::size_t end = solid.size();
      while (end < path.size() && std::isdigit(static_cast<unsigned char>(path[end])))
        ++end;
      if (end == solid.size() || (end < path.size() && path[end] != '/'))
        return "";
      if (end == path.size())
        return "'Solids/NAME' with 'set Solids = NAME'";
      std::string entry = path.substr(end + 1);
      if (const auto found = renamed_of_solid().find(entry); found != renamed_of_solid().end())
        entry = found->second;
      return "'Solids/NAME/" + entry + "' with 'set Solids = NAME'";
    }
    return "";
  }
} // namespace Lahar
