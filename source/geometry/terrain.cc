// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/grid_lines.h>
#include <lahar/geometry/map_raster.h>
#include <lahar/geometry/terrain.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace Lahar
{
  namespace
  {
    /// The window of an entry 'x0, x1, y0, y1'; none if it is empty. @throws InputError
    std::optional<Box<2>> parse_window(const Parameters &prm)
    {
      const std::string allowed            = "'x0, x1, y0, y1' with x0 < x1 and y0 < y1";
      const std::vector<std::string> words = split_list(prm.get("Window"), ',');
      if (words.empty())
        return {};
      std::vector<double> numbers;
      try
      {
        for (const std::string &word : words)
          numbers.push_back(to_number(word));
      }
      catch (const std::invalid_argument &)
      {
        prm.throw_wrong_value("Window", allowed);
      }
      if (numbers.size() != 4 || !(numbers[0] < numbers[1] && numbers[2] < numbers[3]))
        prm.throw_wrong_value("Window", allowed);
      return Box<2>({numbers[0], numbers[2]}, {numbers[1], numbers[3]});
    }
  } // namespace



  void Terrain::declare_parameters(Parameters &prm)
  {
    prm.declare_file("File", "An elevation grid: an ESRI ASCII grid (.asc) or a GeoTIFF with one band, in m. "
                             "Its cells' values are the elevations of their middles.");
    prm.declare_list(
      "Window", "", ',',
      "The part of the map that is the ground, 'x0, x1, y0, y1' in the file's coordinates; if empty, "
      "all that lies between the middles of the file's cells.");
    prm.declare_vector(
      "Origin", "0, 0, 0", 3,
      "Point 'x, y, z' of the map that is the origin of the case: it is subtracted from coordinates "
      "and elevations. With the large coordinates of UTM digits are lost otherwise.");
    prm.declare_positive(
      "Spacing", "0",
      "Distance of the ground's grid lines in m, between which it is made of triangles; best about "
      "the mesh size. Elevations are bilinear between the cells' middles. 0: the lines of the file.");
  }



  Terrain::Terrain(const Parameters &prm)
    : file(prm.get("File"))
    , spacing_path(prm.path("Spacing"))
    , shift(prm.get_vector<3>("Origin"))
    , in_map({0., 0.}, {0., 0.})
  {
    if (file.empty())
      prm.throw_wrong_value("File", "the name of an ESRI ASCII grid (.asc) or a GeoTIFF");
    const double wanted                = prm.get_positive("Spacing", true);
    const std::optional<Box<2>> window = parse_window(prm);
    const MapRaster raster(file, window);
    has_projection = raster.has_projection();
    in_map         = window ? *window : raster.extent();
    for (unsigned int d = 0; d < 2; ++d)
    {
      if (!(in_map.upper[d] > in_map.lower[d]))
        throw InputError("Grid '" + file + "' is one cell wide. Allowed: at least two cells along x and y.");
      lines[d] = grid_lines(in_map.lower[d], in_map.upper[d], wanted, raster.lines(d));
    }
    double n_nodes = lines[0].size() * double(lines[1].size());
    if (wanted > 0.)
      n_nodes = (1. + (in_map.upper[0] - in_map.lower[0]) / wanted) *
                (1. + (in_map.upper[1] - in_map.lower[1]) / wanted);
    if (n_nodes > most_grid_lines)
    {
      std::ostringstream found;
      found << "a larger one, or a smaller 'Window': with this one the ground has about " << n_nodes
            << " points, and at most " << most_grid_lines << " are possible";
      prm.throw_wrong_value("Spacing", found.str());
    }

    unsigned int n_gaps = 0;
    Point<2> first_gap;
    for (const double y : lines[1])
      for (const double x : lines[0])
      {
        elevations.push_back(raster.value({x, y}));
        if (std::isnan(elevations.back()) && n_gaps++ == 0)
          first_gap = Point<2>(x, y);
      }
    if (n_gaps > 0)
    {
      std::ostringstream message;
      message.precision(12);
      message << "Grid '" << file << "' has no elevation at " << n_gaps << " of " << elevations.size()
              << " points of the ground, the first at (" << first_gap << ") m. Allowed: a '"
              << prm.path("Window") << "' without gaps (gdal_fillnodata.py fills them).";
      throw InputError(message.str());
    }
  }



  double Terrain::spacing() const
  {
    return 0.5 * ((in_map.upper[0] - in_map.lower[0]) / (lines[0].size() - 1.) +
                  (in_map.upper[1] - in_map.lower[1]) / (lines[1].size() - 1.));
  }



  Point<3> Terrain::node(const unsigned int i, const unsigned int j) const
  {
    return Point<3>(lines[0][i] - shift[0], lines[1][j] - shift[1],
                    elevations[std::size_t(j) * lines[0].size() + i] - shift[2]);
  }



  double Terrain::elevation(const Point<2> &place) const
  {
    std::array<unsigned int, 2> cell;
    std::array<double, 2> part;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const std::vector<double> &line = lines[d];
      // Points on the rim may lie beside it by rounding.
      const double x = place[d] + shift[d], rounding = 1e-9 * (line.back() - line.front());
      if (!(x >= line.front() - rounding && x <= line.back() + rounding))
        return std::numeric_limits<double>::quiet_NaN();
      cell[d] = std::upper_bound(line.begin() + 1, line.end() - 1, x) - line.begin() - 1;
      part[d] = (x - line[cell[d]]) / (line[cell[d] + 1] - line[cell[d]]);
    }
    const auto [i, j]   = cell;
    const double corner = node(i, j)[2], opposite = node(i + 1, j + 1)[2];
    const double beside  = part[0] > part[1] ? node(i + 1, j)[2] : node(i, j + 1)[2];
    const double largest = std::max(part[0], part[1]), least = std::min(part[0], part[1]);
    return corner + largest * (beside - corner) + least * (opposite - beside);
  }



  std::vector<std::array<Point<3>, 3>> Terrain::triangles() const
  {
    std::vector<std::array<Point<3>, 3>> result;
    for (unsigned int j = 0; j + 1 < lines[1].size(); ++j)
      for (unsigned int i = 0; i + 1 < lines[0].size(); ++i)
      {
        const Point<3> corner = node(i, j), opposite = node(i + 1, j + 1);
        result.push_back({{corner, node(i + 1, j), opposite}});
        result.push_back({{corner, opposite, node(i, j + 1)}});
      }
    return result;
  }



  std::vector<std::string> Terrain::check_scale(const std::string &name, const double h) const
  {
    std::vector<std::string> result = check_grid_spacing(name, spacing(), h, spacing_path);
    if (!has_projection)
      result.push_back("Warning: grid '" + file +
                       "' does not name its projection; its coordinates are taken as m.");
    return result;
  }
} // namespace Lahar
