// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_fluid_shape_h
#define lahar_geometry_fluid_shape_h

#include <lahar/geometry/fluid_body.h>
#include <lahar/utilities/parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The shape of a fluid at the start: one or more bodies.
   *
   * A model of this kind registers itself with Factory<FluidShape<dim>>; its parameters stand in the subsection of its
   * name in that of the fluid.
   */
  template <int dim>
  class FluidShape
  {
  public:
    using Bodies = std::vector<std::unique_ptr<FluidBody<dim>>>;

    virtual ~FluidShape() = default;

    /// Read the shape's own subsection. @throws InputError for a shape without volume.
    virtual void parse_parameters(Parameters &prm) = 0;

    /// The bodies of the fluid that messages call @p name.
    virtual Bodies bodies(const std::string &name) const = 0;

    /// @throws InputError if lengths of the shape are out of all proportion to the mesh size @p h (m).
    virtual void check_scale(const double /*h*/) const {}
  };

  /// How messages call body @p number, from 0, of the @p n bodies of the fluid @p name.
  inline std::string body_name(const std::string &name, const std::size_t number, const std::size_t n)
  {
    return n == 1 ? name : name + " (number " + std::to_string(number + 1) + ")";
  }
} // namespace Lahar

#endif
