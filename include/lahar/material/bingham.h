// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_bingham_h
#define lahar_material_bingham_h

#include <lahar/material/yield_stress_law.h>

namespace Lahar
{
  /**
   * The Bingham fluid with the plastic viscosity μ, regularised by Papanastasiou (J. Rheol. 31 (1987) 385):
   *
   *   μ_eff(γ̇) = μ + τ0 (1 − exp(−m γ̇)) / γ̇.
   *
   * Stress grows with γ̇ everywhere: d(μ_eff γ̇)/dγ̇ = μ + m τ0 exp(−m γ̇).
   */
  class Bingham : public YieldStressLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    double mu = 0.;
  };
} // namespace Lahar

#endif
