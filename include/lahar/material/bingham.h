// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_bingham_h
#define lahar_material_bingham_h

#include <lahar/material/fluid_law.h>

namespace Lahar
{
  /**
   * The Bingham fluid regularised by Papanastasiou (J. Rheol. 31 (1987) 385):
   *
   *   μ_eff(γ̇) = μ + τ0 f(γ̇),   f(γ̇) = (1 − exp(−m γ̇)) / γ̇.
   *
   * f(0) = m and f'(0) = −m²/2; as m → ∞, f γ̇ → 1 wherever γ̇ > 0. Stress grows with γ̇ everywhere:
   * d(μ_eff γ̇)/dγ̇ = μ + m τ0 exp(−m γ̇).
   */
  class Bingham : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    double yield_stress() const override
    {
      return tau_0;
    }

    Value viscous_part(const double strain_rate) const override;

    Value plastic_part(const double strain_rate) const override;

  private:
    double mu    = 0.;
    double tau_0 = 0.;
    double m     = 0.;
  };
} // namespace Lahar

#endif
