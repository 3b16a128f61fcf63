// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_terrain_h
#define lahar_geometry_terrain_h

#include <lahar/geometry/box.h>

#include <array>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Ground from an elevation grid (MapRaster), as triangles: the rectangles between grid lines along x and y, each halved
   * from its south-western to its north-eastern corner.
   *
   * The grid lines are those of the file's cells, or others at a wanted spacing; the elevation of their crossings is
   * bilinear between the cells' middles. Map coordinates become coordinates of the case when the origin is subtracted.
   */
  class Terrain
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// Read the handler's current section. @throws InputError, also for gaps in the window.
    explicit Terrain(const Parameters &prm);

    const std::string &file_name() const
    {
      return file;
    }

    /// The part of the map that is the ground.
    const Box<2> &window() const
    {
      return in_map;
    }

    /// What is subtracted from map coordinates and elevations.
    const Tensor<1, 3> &origin() const
    {
      return shift;
    }

    /// Mean distance of grid lines, m.
    double spacing() const;

    /// z of the triangles over a point, x and y in coordinates of the case; NaN beside the window.
    double elevation(const Point<2> &place) const;

    /// Counterclockwise seen from above, in coordinates of the case.
    std::vector<std::array<Point<3>, 3>> triangles() const;

    /// Warnings about the file, and if the grid is far finer or coarser than the mesh size @p h (m); messages call the
    /// boundary @p name. @throws InputError if it is so by a factor of 10⁴.
    std::vector<std::string> check_scale(const std::string &name, const double h) const;

  private:
    Point<3> node(const unsigned int i, const unsigned int j) const;

    std::string file, spacing_path;
    Tensor<1, 3> shift;
    Box<2> in_map;
    std::array<std::vector<double>, 2> lines; ///< in map coordinates
    std::vector<double> elevations;           ///< of the crossings, row by row along x
    bool has_projection = false;
  };
} // namespace Lahar

#endif
