// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/boundary_shape.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/mesh_entries.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Physical groups of a gmsh file: each edge is a wall in the plane, all triangles of a group are one in space.
  template <int dim>
  class MeshBoundary : public BoundaryShape<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      declare_mesh_entries(prm, std::string(dim == 2 ? "curves" : "surfaces") + " that are the boundary");
    }

    void parse_parameters(Parameters &prm) override
    {
      const MeshEntries entries(prm);
      path = entries.scale_path;
      const GmshFile<dim> file(entries.file_name, entries.scale, entries.element_size);
      for (const std::string &group : entries.groups)
      {
        WallShape<dim> wall;
        wall.name = "group '" + group + "'";
        if constexpr (dim == 2)
          for (const auto &[a, b] : file.facets_of(group))
          {
            wall.corners = {a, b};
            shapes.push_back(wall);
          }
        else
        {
          wall.mesh_facets = file.facets_of(group);
          shapes.push_back(wall);
        }
      }
    }

    std::vector<WallShape<dim>> walls() const override
    {
      return shapes;
    }

    std::string scale_path() const override
    {
      return path;
    }

  private:
    std::vector<WallShape<dim>> shapes;
    std::string path;
  };



  static const Factory<BoundaryShape<2>>::Registration<MeshBoundary<2>> mesh_2d("mesh",
                                                                                "Curves of a gmsh file.");
  static const Factory<BoundaryShape<3>>::Registration<MeshBoundary<3>> mesh_3d("mesh",
                                                                                "Surfaces of a gmsh file.");
} // namespace Lahar
