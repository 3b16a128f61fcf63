// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_surface_law_h
#define lahar_boundary_surface_law_h

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * How fluid moves along a rigid surface that it touches: it sticks to it, or it slides. Where it slides with the
   * velocity s relative to the surface, the surface exerts on it the shear traction
   *
   *   t = −[β s + τ_c P],   P = s/|s| for s ≠ 0, and |P| ≤ 1 whatever holds the fluid for s = 0,
   *
   * see SlidingContact.
   *
   * A model of this kind registers itself with Factory<SurfaceLaw>; its parameters stand in the subsection of its name in
   * that of the boundary.
   */
  class SurfaceLaw
  {
  public:
    /// β and τ_c.
    struct Resistance
    {
      double viscous              = 0.; ///< β, Pa s/m
      double threshold            = 0.; ///< τ_c, Pa
      double threshold_derivative = 0.; ///< dτ_c/dN
    };

    virtual ~SurfaceLaw() = default;

    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// Whether fluid lands on the surface (WallContact); the surface carries particles otherwise.
    virtual bool lands() const = 0;

    /// Whether fluid that has landed goes with the surface, instead of sliding along it.
    virtual bool sticks() const
    {
      return false;
    }

    /// Whether a surface along which fluid slides resists.
    virtual bool resists() const
    {
      return false;
    }

    /// Its resistance where the fluid presses on it with N ≥ 0, Pa.
    virtual Resistance resistance(const double /*normal_stress*/) const
    {
      return {};
    }
  };
} // namespace Lahar

#endif
