// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_ground_h
#define lahar_geometry_ground_h

#include <lahar/geometry/box.h>
#include <lahar/geometry/profile.h>
#include <lahar/geometry/terrain.h>
#include <lahar/utilities/parameters.h>

#include <string>
#include <type_traits>

namespace Lahar
{
  /**
   * The ground of a boundary of the shape 'terrain' as an elevation over the other coordinates, under something that
   * stands on it.
   */
  template <int dim>
  class Ground
  {
  public:
    /// The ground of the boundary that @p entry of the handler's current section names, under what messages call
    /// @p above. @throws InputError
    Ground(Parameters &prm, const std::string &entry, const std::string &above);

    /// The last coordinate of the ground over or under a point, in coordinates of the case, m. @throws InputError if it
    /// is beside the ground.
    double elevation(const Point<dim> &place) const;

    /// Raised by the elevation of the ground under it.
    Point<dim> raised(const Point<dim> &drawn) const;

    /// The box around all points of a box that are raised, to within the ground's unevenness between points a twentieth
    /// of the box apart.
    Box<dim> raised(const Box<dim> &drawn) const;

  private:
    std::conditional_t<dim == 2, Profile, Terrain> ground;
    std::string path, boundary, above; ///< of the entry; its value
  };
} // namespace Lahar

#endif
