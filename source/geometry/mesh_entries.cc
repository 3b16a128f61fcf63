// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/gmsh_model.h>
#include <lahar/geometry/mesh_entries.h>

namespace Lahar
{
  void declare_mesh_entries(Parameters &prm, const std::string &groups)
  {
    prm.declare_file(
      "File",
      "A mesh of gmsh's (.msh), or a geometry that gmsh meshes: a script of its own (.geo) or a drawing of CAD "
      "(.step, .stp, .brep, .iges, .igs). The name is relative to the parameter file that gives it (on the "
      "command line: to the working directory). Elements of second order count as straight ones.");
    prm.declare_positive(
      "Element size", "0",
      "Length of edges that gmsh aims at where it meshes a geometry, m; 0: what a script says. "
      "A drawing of CAD needs it, a mesh has its elements.");
    prm.declare_positive("Scale", "1",
                         "Factor for the file's coordinates, above zero: 1e-3 for a mesh in mm.");
    prm.declare_list(
      "Groups", "", ',',
      "The file's physical " + groups +
        ", by names or tags separated by commas; a name with a comma in it stands in double quotes. In a geometry "
        "without groups each entity is one, by its tag.");
  }



  MeshEntries::MeshEntries(const Parameters &prm)
    : file_name(prm.get("File"))
    , scale(prm.get_positive("Scale"))
    , groups(prm.get_names("Groups"))
    , element_size(prm.get_positive("Element size", true))
    , scale_path(prm.path("Scale"))
  {
    if (file_name.empty())
      prm.throw_wrong_value("File", "the name of a gmsh file");
    if (element_size > 0. && !GmshModel::is_geometry(file_name))
      prm.throw_wrong_value("Element size", "0, since '" + file_name +
                                              "' is no geometry that gmsh meshes (.geo, " +
                                              ".step, .brep, .iges)");
    if (element_size == 0. && GmshModel::is_drawing(file_name))
      prm.throw_wrong_value("Element size", "the length of edges that gmsh is to aim at in '" + file_name +
                                              "', in m, above zero");
    if (groups.empty())
      prm.throw_wrong_value("Groups", "names or tags of physical groups of '" + file_name + "'");
  }
} // namespace Lahar
