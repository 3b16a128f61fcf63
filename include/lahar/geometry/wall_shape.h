// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_wall_shape_h
#define lahar_geometry_wall_shape_h

#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/walls.h>

#include <string>
#include <vector>

namespace Lahar
{
  /// What lies nearer to a wall or to a solid than this times h touches it.
  constexpr double touching = 1e-3;

  /**
   * A rigid wall as the user gives it: a polyline in the plane; in space a convex plane polygon, or the triangles of a
   * mesh file.
   */
  template <int dim>
  struct WallShape
  {
    std::string name; ///< how messages to the user call it
    std::vector<Point<dim>> corners;
    bool closed = false; ///< of a polyline: the last corner is joined to the first
    std::vector<std::array<Point<dim>, dim>> mesh_facets; ///< in space, instead of corners
    bool lands            = false;                        ///< see WallFacet
    unsigned int boundary = 0;                            ///< see WallFacet
    bool moves            = false;                        ///< see WallFacet
    bool sticks           = false;                        ///< see WallFacet

    std::vector<WallFacet<dim>> facets() const;

    /// About how many points particles() works on.
    double estimate_size(const double h) const;

    /// Particles at the distance @p h, among them the @p contacts: points of the wall where something touches it. Corners
    /// of facets that are smaller than 0.6 h carry none.
    std::vector<Point<dim>> particles(const std::vector<Point<dim>> &contacts, const MeshSize<dim> &h) const;

    /// Points of the wall about 0.2 h apart (0.5 h in space), to see what it meets.
    std::vector<Point<dim>> samples(const double h) const;

    /// Whether @p point lies deeper than @p tolerance in a closed wall.
    bool encloses(const Point<dim> &point, const double tolerance) const;

    /// Whether the wall is closed and all @p points lie inside, or nearer to it than @p tolerance: it is their tank.
    bool holds(const std::vector<Point<dim>> &points, const double tolerance) const;

  private:
    /// The wall in space as triangles.
    std::vector<std::array<Point<3>, 3>> triangles() const;
  };

  template <>
  std::vector<WallFacet<3>> WallShape<3>::facets() const;
} // namespace Lahar

#endif
