// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_hill_h
#define lahar_tests_hill_h

#include <deal.II/base/point.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <limits>
#include <string>
#include <vector>

namespace Tests
{
  using namespace dealii;

  /// A function of x and y on the points of a grid, as files.
  struct Grid
  {
    double x0 = 0., y0 = 0.; ///< lower left point
    double spacing  = 0.1;
    unsigned int nx = 21, ny = 17;
    std::function<double(const double, const double)> z;

    double at(const unsigned int i, const unsigned int j) const
    {
      return z(x0 + i * spacing, y0 + j * spacing);
    }

    /// ESRI ASCII, its lines from the north; where the function is nan a gap.
    void write_asc(const std::string &name) const
    {
      std::ofstream out(name);
      out << std::setprecision(17) << "ncols " << nx << "\nnrows " << ny << "\nxllcenter " << x0
          << "\nyllcenter " << y0 << "\ncellsize " << spacing << "\nNODATA_value -9999\n";
      for (unsigned int j = ny; j-- > 0;)
        for (unsigned int i = 0; i < nx; ++i)
          out << (std::isnan(at(i, j)) ? -9999. : at(i, j)) << (i + 1 < nx ? ' ' : '\n');
    }

    std::vector<std::array<Point<3>, 3>> triangles() const
    {
      std::vector<std::array<Point<3>, 3>> result;
      const auto node = [this](const unsigned int i, const unsigned int j) {
        return Point<3>(x0 + i * spacing, y0 + j * spacing, at(i, j));
      };
      for (unsigned int j = 0; j + 1 < ny; ++j)
        for (unsigned int i = 0; i + 1 < nx; ++i)
        {
          result.push_back({{node(i, j), node(i + 1, j), node(i + 1, j + 1)}});
          result.push_back({{node(i, j), node(i + 1, j + 1), node(i, j + 1)}});
        }
      return result;
    }
  };

  /// Text STL of triangles.
  inline void write_stl(const std::string &name, const std::vector<std::array<Point<3>, 3>> &triangles)
  {
    std::ofstream out(name);
    out << std::setprecision(17) << "solid test\n";
    for (const auto &triangle : triangles)
    {
      out << "facet normal 0 0 1\n outer loop\n";
      for (const Point<3> &p : triangle)
        out << "  vertex " << p << '\n';
      out << " endloop\nendfacet\n";
    }
    out << "endsolid test\n";
  }

  /// The same as OBJ (of the points of each triangle) or OFF, without common points.
  inline void write_indexed(const std::string &name, const std::vector<std::array<Point<3>, 3>> &triangles)
  {
    std::ofstream out(name);
    const bool is_obj = name.substr(name.size() - 3) == "obj", is_ply = name.substr(name.size() - 3) == "ply";
    out << std::setprecision(17);
    if (is_ply)
      out << "ply\nformat ascii 1.0\nelement vertex " << 3 * triangles.size()
          << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << triangles.size()
          << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto &triangle : triangles)
      for (const Point<3> &p : triangle)
        out << (is_obj ? "v " : "") << p << '\n';
    for (unsigned int i = 0; i < triangles.size(); ++i)
      out << (is_obj ? "f" : "3") << ' ' << 3 * i + is_obj << ' ' << 3 * i + 1 + is_obj << ' '
          << 3 * i + 2 + is_obj << '\n';
  }
} // namespace Tests

#endif
