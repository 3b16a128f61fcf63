// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_initial_region_h
#define lahar_geometry_initial_region_h

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/simplex_geometry.h>

#include <memory>
#include <vector>

namespace Lahar
{
  /**
   * The region that the fluid is asked to fill at the start: the union of the bodies.
   *
   * A simplex belongs to it if its edges, its centroid and, in space, the centroids of its faces lie in bodies. So slots
   * and notches stay open, bodies that do not touch stay apart, and those that touch share the simplices across their
   * common contour.
   */
  template <int dim>
  class InitialRegion
  {
  public:
    /// @p bodies must outlive this object.
    explicit InitialRegion(const std::vector<std::unique_ptr<FluidBody<dim>>> &bodies);

    /// The sum of the bodies' volumes, see FluidBody::volume().
    double volume() const;

    /// The smallest of the bodies' signed distances.
    double signed_distance(const Point<dim> &point) const;

    /// Whether the simplex belongs to the region enlarged by @p tolerance (m). What its edges pass over that is narrower
    /// than @p resolution (m) may be missed.
    bool holds(const SimplexCorners<dim> &corners, const double tolerance, const double resolution) const;

  private:
    bool holds(const Point<dim> &a, const Point<dim> &b, const double tolerance,
               const double resolution) const;

    std::vector<const FluidBody<dim> *> bodies;
    std::vector<Box<dim>> boxes;
  };
} // namespace Lahar

#endif
