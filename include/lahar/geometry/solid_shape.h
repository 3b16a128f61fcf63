// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_solid_shape_h
#define lahar_geometry_solid_shape_h

#include <deal.II/base/point.h>

#include <deal.II/grid/tria_description.h>

#include <lahar/geometry/box.h>
#include <lahar/utilities/parameters.h>

#include <array>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The undeformed shape of one solid and its simplices: a box, or a physical group of a gmsh file.
   *
   * A box of n_x × n_y (× n_z) rectangles has two triangles in each, whose diagonals alternate (five tetrahedra in 3D).
   */
  template <int dim>
  class SolidShape
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// @throws InputError for a shape without volume, an unknown file or group, bad elements in the file.
    void parse_parameters(Parameters &prm);

    bool is_from_file() const
    {
      return !file_vertices.empty();
    }

    /// The smallest box around the shape.
    Box<dim> box() const;

    /// About how many nodes of finite elements of the given degree append() makes.
    double estimate_size(const double size, const unsigned int degree) const;

    /**
     * Append vertices and positively oriented cells, with the material id @p body.
     * @param size edge length (m) where the parameters do not give the number of elements.
     */
    void append(const double size, const unsigned int body, std::vector<Point<dim>> &vertices,
                std::vector<CellData<dim>> &cells) const;

  private:
    void parse_mesh_file(Parameters &prm);

    /// Number of elements of a box along direction @p d.
    double n_elements_along(const unsigned int d, const double size) const;

    Point<dim> lower, upper;
    std::array<unsigned int, dim> n_elements = {}; ///< of a box; 0: from the size
    std::vector<Point<dim>> file_vertices;         ///< empty for a box
    std::vector<CellData<dim>> file_cells;
  };
} // namespace Lahar

#endif
