// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_gmsh_model_h
#define lahar_geometry_gmsh_model_h

#include <string>

namespace Lahar
{
  /**
   * A geometry that gmsh meshes: a script of gmsh's own (.geo, .geo_unrolled) or a drawing of CAD (.step, .stp, .brep,
   * .iges, .igs). The mesh is written into a temporary file of format 4.1, which goes with the object.
   *
   * A geometry without physical groups, as those of CAD, has one for each of its entities, by the entity's tag.
   */
  class GmshModel
  {
  public:
    /// Whether the name ends as one of a geometry's does, in small or capital letters.
    static bool is_geometry(const std::string &file_name);

    /// Whether it is a drawing of CAD, which has no sizes of elements.
    static bool is_drawing(const std::string &file_name);

    /**
     * Mesh the geometry.
     * @param dimension that of its elements.
     * @param element_size length of edges that gmsh aims at, in units of the file; larger ones of a script's are made
     * smaller; 0: what the file says.
     * @throws InputError with gmsh's words for what it cannot read or mesh.
     */
    GmshModel(const std::string &file_name, const unsigned int dimension, const double element_size);

    ~GmshModel();

    GmshModel(const GmshModel &)            = delete;
    GmshModel &operator=(const GmshModel &) = delete;

    /// The temporary mesh file.
    const std::string &mesh_file() const
    {
      return mesh_file_name;
    }

  private:
    std::string mesh_file_name;
  };
} // namespace Lahar

#endif
