// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_mesh_entries_h
#define lahar_geometry_mesh_entries_h

#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /// The entries of a shape 'mesh', physical groups of a gmsh file. @param groups what they are, as "surfaces".
  void declare_mesh_entries(Parameters &prm, const std::string &groups);

  /// Their values.
  struct MeshEntries
  {
    std::string file_name;
    double scale = 1.;               ///< m per unit of the file
    std::vector<std::string> groups; ///< at least one
    double element_size = 0.;        ///< length of edges that gmsh aims at, m; 0: as the file says
    std::string scale_path;          ///< the full path of the entry 'Scale'

    /// Read the handler's current section. @throws InputError
    explicit MeshEntries(const Parameters &prm);
  };
} // namespace Lahar

#endif
