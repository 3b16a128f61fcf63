// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_gmsh_file_h
#define lahar_geometry_gmsh_file_h

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * The points and the physical groups of a gmsh mesh (ASCII, file format 2.2 or 4.1): what the cloud needs of it.
   *
   * Groups of cells are made of triangles and quadrilaterals of first order in the plane, of tetrahedra in space;
   * groups of facets of lines in the plane, of triangles and quadrilaterals in space. A quadrilateral counts as two
   * triangles. Elements of a lower dimension are ignored, others are refused. An element belongs to all groups of its
   * entity.
   */
  template <int dim>
  class GmshFile
  {
  public:
    /// Read the file. @throws InputError with file name and line for a missing, truncated or malformed file.
    explicit GmshFile(const std::string &file_name);

    /// Nodes of the cells of @p group, a physical surface (in space: volume), each once, by ascending node tag.
    /// @throws InputError with the names that exist.
    std::vector<Point<dim>> nodes_of(const std::string &group) const;

    /**
     * The cells of @p group: its nodes as by nodes_of(), and corner numbers in @p points.
     * @throws InputError with the names that exist, or for a cell without volume.
     */
    void cells_of(const std::string &group, std::vector<Point<dim>> &points,
                  std::vector<std::array<unsigned int, dim + 1>> &simplices) const;

    /// Facets of @p group, a physical curve (in space: surface), in the order of the file. @throws InputError with the
    /// names that exist.
    const std::vector<std::array<Point<dim>, dim>> &facets_of(const std::string &group) const;

  private:
    /// Fills the members from the file.
    class Parser;

    /// Tag of the group, by dimension and name.
    long find_group(const unsigned int dimension, const std::string &group) const;

    std::string file_name;
    bool is_flat = true;                                         ///< all nodes have z = 0
    std::map<std::size_t, Point<dim>> nodes;                     ///< by node tag
    std::map<std::pair<unsigned int, std::string>, long> groups; ///< group tags, by dimension and name
    std::map<long, std::vector<std::array<std::size_t, dim + 1>>> cells; ///< node tags, by group tag
    std::map<long, std::vector<std::array<Point<dim>, dim>>> facets;     ///< by group tag
  };
} // namespace Lahar

#endif
