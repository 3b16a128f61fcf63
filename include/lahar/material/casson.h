// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_casson_h
#define lahar_material_casson_h

#include <lahar/material/regularized_power.h>
#include <lahar/material/yield_stress_law.h>

namespace Lahar
{
  /**
   * Casson's fluid (in Mill, Rheology of Disperse Systems, 1959), √|τ| = √τ0 + √(μ_c γ̇), that is
   * |τ| = τ0 + μ_c γ̇ + 2 √(τ0 μ_c γ̇), regularised:
   *
   *   μ_eff(γ̇) = μ_c + 2 √(τ0 μ_c) (γ̇² + ε²)^(−1/4) + τ0 (1 − exp(−m γ̇)) / γ̇.
   *
   * The first two terms are the viscous part. Without yield stress it is Newton's with the viscosity μ_c.
   */
  class Casson : public YieldStressLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    double mu = 0.;
    RegularizedPower mixed_part;
  };
} // namespace Lahar

#endif
