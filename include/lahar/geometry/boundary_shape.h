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

    /// What is odd about the shape at the mesh size @p h (m); messages call the boundary @p name. @throws InputError if
    /// lengths of the shape are out of all proportion to it.
    virtual std::vector<std::string> check_scale(const std::string & /*name*/, const double /*h*/) const
    {
      return {};
    }

    /// The full path of the parameter that scales a shape from a file; empty for others.
    virtual std::string scale_path() const
    {
      return "";
    }
  };
} // namespace Lahar

#endif
