// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/mesh_entries.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/solid_shape.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Physical groups of a gmsh file, whose simplices are the solid's elements.
  template <int dim>
  class MeshSolid : public SolidShape<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      declare_mesh_entries(prm, std::string(dim == 2 ? "surfaces" : "volumes") +
                                  " that are the solid, whose elements are the file's");
    }

    void parse_parameters(Parameters &prm) override;

    Box<dim> box() const override
    {
      return box_around(vertices);
    }

    double estimate_size(const double /*size*/, const unsigned int degree) const override
    {
      return degree == 1 ? vertices.size() : vertices.size() + 1.5 * cells.size();
    }

    void append(const double /*size*/, const unsigned int body, std::vector<Point<dim>> &all_vertices,
                std::vector<CellData<dim>> &all_cells) const override
    {
      const unsigned int first = all_vertices.size();
      all_vertices.insert(all_vertices.end(), vertices.begin(), vertices.end());
      for (CellData<dim> cell : cells)
      {
        for (unsigned int &vertex : cell.vertices)
          vertex += first;
        cell.material_id = body;
        all_cells.push_back(cell);
      }
    }

    std::string scale_path() const override
    {
      return path;
    }

  private:
    std::vector<Point<dim>> vertices;
    std::vector<CellData<dim>> cells;
    std::string path;
  };



  template <int dim>
  void MeshSolid<dim>::parse_parameters(Parameters &prm)
  {
    const MeshEntries entries(prm);
    path = entries.scale_path;
    if (entries.groups.size() != 1)
      prm.throw_wrong_value("Groups", "one group, as parts of a solid share their nodes");
    const GmshFile<dim> file(entries.file_name, entries.scale, entries.element_size);
    std::vector<Simplex<dim>> simplices;
    file.cells_of(entries.groups[0], vertices, simplices);
    for (Simplex<dim> simplex : simplices)
    {
      if (signed_volume<dim>(corners_of<dim>(simplex, vertices)) < 0.)
        std::swap(simplex[1], simplex[2]);
      cells.emplace_back(dim + 1);
      std::copy(simplex.begin(), simplex.end(), cells.back().vertices.begin());
    }
  }



  static const Factory<SolidShape<2>>::Registration<MeshSolid<2>> mesh_solid_2d("mesh",
                                                                                "A surface of a gmsh file.");
  static const Factory<SolidShape<3>>::Registration<MeshSolid<3>> mesh_solid_3d("mesh",
                                                                                "A volume of a gmsh file.");
} // namespace Lahar
