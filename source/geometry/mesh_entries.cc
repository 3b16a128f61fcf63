// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/mesh_entries.h>

namespace Lahar
{
  void declare_mesh_entries(Parameters &prm, const std::string &groups)
  {
    prm.declare_file(
      "File", "A gmsh file (.msh); its name is relative to the parameter file that gives it (on the command "
              "line: to the working directory). Elements of second order count as straight ones.");
    prm.declare_positive("Scale", "1",
                         "Factor for the file's coordinates, above zero: 1e-3 for a mesh in mm.");
    prm.declare_list(
      "Groups", "", ',',
      "The file's physical " + groups +
        ", by names or tags separated by commas; a name with a comma in it stands in double quotes.");
  }



  MeshEntries::MeshEntries(const Parameters &prm)
    : file_name(prm.get("File"))
    , scale(prm.get_positive("Scale"))
    , groups(prm.get_names("Groups"))
    , scale_path(prm.path("Scale"))
  {
    if (file_name.empty())
      prm.throw_wrong_value("File", "the name of a gmsh file");
    if (groups.empty())
      prm.throw_wrong_value("Groups", "names or tags of physical groups of '" + file_name + "'");
  }
} // namespace Lahar
