// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_boundary_shape_h
#define lahar_geometry_boundary_shape_h

#include <lahar/geometry/wall_shape.h>
#include <lahar/utilities/parameters.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The shape of a boundary: one or more walls.
   *
   * A model of this kind registers itself with Factory<BoundaryShape<dim>>; its parameters stand in the subsection of its
   * name in that of the boundary.
   */
  template <int dim>
  class BoundaryShape
  {
  public:
    virtual ~BoundaryShape() = default;

    /// Read the shape's own subsection. @throws InputError for a shape without extent.
    virtual void parse_parameters(Parameters &prm) = 0;

    /// The walls, without names or with names of their own, as "group 'bed'".
    virtual std::vector<WallShape<dim>> walls() const = 0;

    /// The full path of the parameter that scales a shape from a file; empty for others.
    virtual std::string scale_path() const
    {
      return "";
    }
  };
} // namespace Lahar

#endif
