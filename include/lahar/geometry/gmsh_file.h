// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_gmsh_file_h
#define lahar_geometry_gmsh_file_h

#include <deal.II/base/point.h>

#include <lahar/geometry/box.h>

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
   * The points and the physical groups of a gmsh mesh (file format 2 or 4.1, ASCII or binary, or 4.0, ASCII), or of a
   * geometry that gmsh meshes (GmshModel): what the cloud needs of it.
   *
   * A group is called by its name, or by its tag if no group of its dimension has that name. Groups of cells are made
   * of triangles and quadrilaterals in the plane, of tetrahedra in space; groups of facets of lines in the plane, of
   * triangles and quadrilaterals in space. A quadrilateral counts as two triangles, an element of second order as one
   * of first order with its corners. Elements of a lower dimension are ignored, others are refused. An element belongs
   * to all groups of its entity.
   */
  template <int dim>
  class GmshFile
  {
  public:
    /**
     * Read the file and multiply its coordinates by @p scale.
     * @param element_size length of edges that gmsh aims at in a geometry, m; 0: what the file says.
     * @throws InputError with file name and line (byte) for a missing, truncated or malformed file.
     */
    explicit GmshFile(const std::string &file_name, const double scale = 1., const double element_size = 0.);

    /// Corners of the cells of @p group, a physical surface (in space: volume), each once, by ascending node tag.
    /// @throws InputError with the names that exist.
    std::vector<Point<dim>> nodes_of(const std::string &group) const;

    /**
     * The cells of @p group: its nodes as by nodes_of(), and corner numbers in @p points.
     * @throws InputError with the names that exist, or for a cell without volume.
     */
    void cells_of(const std::string &group, std::vector<Point<dim>> &points,
                  std::vector<std::array<unsigned int, dim + 1>> &simplices) const;

    /// Mean length of the edges of the cells of @p group. @throws InputError with the names that exist.
    double mean_edge(const std::string &group) const;

    /// Facets of @p group, a physical curve (in space: surface), in the order of the file. @throws InputError with the
    /// names that exist.
    const std::vector<std::array<Point<dim>, dim>> &facets_of(const std::string &group) const;

  private:
    /// Fills the members from the file.
    class Parser;

    /// Tag of the group, by dimension and name or tag.
    long find_group(const unsigned int dimension, const std::string &group) const;

    std::string file_name;
    bool is_flat = true;                     ///< all nodes have z = 0
    std::map<std::size_t, Point<dim>> nodes; ///< by node tag
    std::map<std::pair<unsigned int, std::string>, long>
      groups; ///< tags of groups with names, by dimension and name
    std::map<long, std::vector<std::array<std::size_t, dim + 1>>> cells; ///< node tags, by group tag
    std::map<long, std::vector<std::array<Point<dim>, dim>>> facets;     ///< by group tag
  };

  /// A warning if @p what of a mesh file, with the box around it, is 1e4 times as long as the mesh size @p h (m) or no
  /// longer than that; @p entry is the parameter that scales it.
  template <int dim>
  std::vector<std::string> warn_of_extent(const std::string &what, const Box<dim> &box, const double h,
                                          const std::string &entry);
} // namespace Lahar

#endif
