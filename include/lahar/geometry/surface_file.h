// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_surface_file_h
#define lahar_geometry_surface_file_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * The triangles of a drawing's surface in space: STL, OBJ, PLY or OFF, read, checked and mended by CGAL.
   *
   * Points in the same place become one, polygons triangles, triangles without area go, neighbours are turned the same way
   * round, and rims shorter than a twentieth of the surface's diagonal are closed. All but the first two is said in
   * remarks(), and so are short rims that stay. Surfaces may be open, and more than two faces may meet at an edge.
   */
  class SurfaceFile
  {
  public:
    /**
     * @param scale m per unit of the file.
     * @param spacing wanted length of the triangles' edges in m, zero for those of the file. Sharp edges, above 30°, and
     * rims stay where they are.
     * @param spacing_entry the parameter that says so, for messages.
     * @throws InputError with the file's name for one that is missing or not of a known kind, with a place for triangles
     * that cross others, and for a spacing that gives more than 4 million triangles.
     */
    SurfaceFile(const std::string &file_name, const double scale, const double spacing,
                const std::string &spacing_entry);

    const std::vector<std::array<Point<3>, 3>> &triangles() const
    {
      return all_triangles;
    }

    /// What was mended and what is odd, for the user.
    const std::vector<std::string> &remarks() const
    {
      return all_remarks;
    }

  private:
    std::vector<std::array<Point<3>, 3>> all_triangles;
    std::vector<std::string> all_remarks;
  };
} // namespace Lahar

#endif
