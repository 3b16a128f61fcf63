// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_map_raster_h
#define lahar_geometry_map_raster_h

#include <deal.II/base/point.h>

#include <lahar/geometry/box.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Numbers on the rectangular cells of a map: an elevation grid, or a raster of depths.
   *
   * GDAL reads the file, an ESRI ASCII grid (.asc) or a GeoTIFF with one band. A cell's number is the value in its
   * middle, between the middles the values are bilinear. Rows run from west to east, columns along y; coordinates and
   * values are metres.
   */
  class MapRaster
  {
  public:
    /**
     * Read the cells that @p window needs, or all.
     * @throws InputError with the file's name for one that is missing or neither of the two kinds, for a rotated grid, for
     * coordinates in degrees or in units other than metres, and if the window reaches beyond the cells' middles.
     */
    explicit MapRaster(const std::string &file_name, const std::optional<Box<2>> &window = {});

    /// The box around the middles of the cells that were read.
    Box<2> extent() const;

    /// Distances of the cells' middles along x and y.
    const std::array<double, 2> &cell_size() const
    {
      return size;
    }

    /// Coordinates of the cells' middles along x (0) and y (1), ascending.
    std::vector<double> lines(const unsigned int direction) const;

    /// The value at a point of extent(), up to rounding; a cell that has none counts as @p gap, by default nan.
    double value(const Point<2> &point, const double gap = std::numeric_limits<double>::quiet_NaN()) const;

    /// The value of a cell; nan if it has none.
    double cell(const unsigned int column, const unsigned int row) const
    {
      return values[std::size_t(row) * n[0] + column];
    }

    /// Whether the file says which map its coordinates belong to.
    bool has_projection() const
    {
      return projected;
    }

  private:
    std::array<double, 2> first, size; ///< middle of the cell at the lower left corner, extents of a cell
    std::array<unsigned int, 2> n;     ///< cells along x and y
    std::vector<double> values;        ///< row by row, the southern one first
    bool projected = false;
  };
} // namespace Lahar

#endif
