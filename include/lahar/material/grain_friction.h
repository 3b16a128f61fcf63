// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_grain_friction_h
#define lahar_material_grain_friction_h

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * Friction of flowing grains (Jop, Forterre & Pouliquen, Nature 441 (2006) 727): |τ| = μ(I) P,
   *
   *   μ(I) = μ_s + (μ_d − μ_s) I/(I0 + I),   I = γ̇ d_g/sqrt(P/ρ_s),
   *
   * ρ_s and d_g the grains' density and diameter.
   */
  class GrainFriction
  {
  public:
    /// Declare the entries of the grains and of μ(I).
    static void declare_parameters(Parameters &prm);

    /// @param density of grains and voids, kg/m³. @throws InputError
    void parse_parameters(const Parameters &prm, const double density);

    /// I at P > 0.
    double inertial_number(const double strain_rate, const double pressure) const;

    /// I0 sqrt(P/ρ_s)/d_g, the strain rate at which I is I0, 1/s.
    double reference_rate(const double pressure) const;

    double static_friction() const
    {
      return mu_s;
    }

    double dynamic_friction() const
    {
      return mu_d;
    }

    double reference_inertial_number() const
    {
      return I_0;
    }

    /// A coefficient of friction μ and ν = d ln μ/d ln I.
    struct Value
    {
      double mu = 0., nu = 0.;
    };

    /// μ(I) + @p slope I²/(I0 + I), the latter the linear growth that Barker & Gray (2017) give it at large I.
    Value friction(const double inertial_number, const double slope = 0.) const;

    /**
     * Plane incompressible flow with |τ| = μ(I) P is well-posed where (Barker, Schaeffer, Bohorquez & Gray, J. Fluid Mech.
     * 779 (2015) 794)
     *
     *   C = 4ν² − 4ν + μ² (1 − ν/2)² ≤ 0.
     */
    static bool is_well_posed(const Value &friction);

  private:
    double rho_s = 2500., d_g = 1e-3, mu_s = 0., mu_d = 0., I_0 = 1.;
  };
} // namespace Lahar

#endif
