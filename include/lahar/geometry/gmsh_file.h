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
   * The points and the physical groups of a plane gmsh mesh (ASCII, file format 2.2 or 4.1): what the cloud needs of
   * it.
   *
   * Lines of two nodes make curves, triangles and quadrilaterals of first order make surfaces; points are ignored,
   * other elements are refused. An element belongs to all groups of its entity.
   */
  class GmshFile
  {
  public:
    /// Read the file. @throws InputError with file name and line for a missing, truncated or malformed file.
    explicit GmshFile(const std::string &file_name);

    /// Nodes of the physical surface @p group, each once, by ascending node tag. @throws InputError with the names that
    /// exist.
    std::vector<Point<2>> nodes_of_surface(const std::string &group) const;

    /**
     * The physical surface @p group as triangles: its nodes, and corner numbers in @p points. A quadrilateral counts as
     * two.
     * @throws InputError with the names that exist, or for a triangle without area.
     */
    void triangles_of_surface(const std::string &group, std::vector<Point<2>> &points,
                              std::vector<std::array<unsigned int, 3>> &triangles) const;

    /// Edges of the physical curve @p group, in the order of the file. @throws InputError with the names that exist.
    std::vector<std::array<Point<2>, 2>> edges_of_curve(const std::string &group) const;

  private:
    /// Fills the members from the file.
    class Parser;

    /// Tag of the group, by dimension and name.
    long find_group(const unsigned int dimension, const std::string &group) const;

    std::string file_name;
    std::map<std::size_t, Point<2>> nodes;                       ///< by node tag
    std::map<std::pair<unsigned int, std::string>, long> groups; ///< group tags, by dimension and name
    std::map<long, std::vector<std::array<std::size_t, 2>>> curve_edges;       ///< node tags, by group tag
    std::map<long, std::set<std::size_t>> surface_nodes;                       ///< node tags, by group tag
    std::map<long, std::vector<std::array<std::size_t, 3>>> surface_triangles; ///< node tags, by group tag
  };
} // namespace Lahar

#endif
