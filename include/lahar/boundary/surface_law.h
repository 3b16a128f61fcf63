// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_surface_law_h
#define lahar_boundary_surface_law_h

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * How fluid moves along a rigid surface that it touches.
   *
   * A model of this kind registers itself with Factory<SurfaceLaw>; its parameters stand in the subsection of its name in
   * that of the boundary.
   */
  class SurfaceLaw
  {
  public:
    virtual ~SurfaceLaw() = default;

    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// Whether fluid slides along the surface (SlipCondition); it sticks to particles of the surface otherwise.
    virtual bool slips() const = 0;
  };
} // namespace Lahar

#endif
