// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_herschel_bulkley_h
#define lahar_material_herschel_bulkley_h

#include <lahar/material/regularized_power.h>
#include <lahar/material/yield_stress_law.h>

namespace Lahar
{
  /**
   * The fluid of Herschel & Bulkley (Kolloid-Zeitschrift 39 (1926) 291), |τ| = τ0 + K γ̇^n, regularised:
   *
   *   μ_eff(γ̇) = K (γ̇² + ε²)^((n−1)/2) + τ0 (1 − exp(−m γ̇)) / γ̇.
   *
   * K in Pa s^n is the consistency; n < 1 makes the fluid thin with shear, n > 1 thicken. With n = 1 it is Bingham's.
   */
  class HerschelBulkley : public YieldStressLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    RegularizedPower viscosity;
  };
} // namespace Lahar

#endif
