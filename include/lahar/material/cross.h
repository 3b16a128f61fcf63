// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_cross_h
#define lahar_material_cross_h

#include <lahar/material/fluid_law.h>

namespace Lahar
{
  /**
   * Cross's fluid (J. Colloid Sci. 20 (1965) 417), which falls from one constant viscosity to another:
   *
   *   μ(γ̇) = μ_∞ + (μ_0 − μ_∞) / (1 + (k γ̇)^q).
   *
   * k = 0 is Newton's. For q > 1 the stress falls with γ̇ where μ_∞ is small: d(μ γ̇)/dγ̇ is least at
   * (k γ̇)^q = (q+1)/(q−1), where it is μ_∞ − (μ_0 − μ_∞) (q−1)²/(4q). Entries for which that is negative are refused.
   */
  class Cross : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    /// The derivative is 0 where γ̇ is: for q < 1 it has no limit there, but γ̇ times it has, 0.
    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    double mu_0 = 0., mu_infinity = 0., k = 0., q = 1.;
  };
} // namespace Lahar

#endif
