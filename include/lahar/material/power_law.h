// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_power_law_h
#define lahar_material_power_law_h

#include <lahar/material/regularized_power.h>

namespace Lahar
{
  /**
   * The power law of Ostwald and de Waele, |τ| = K γ̇^n, with a finite viscosity at rest:
   *
   *   μ(γ̇) = K (γ̇² + ε²)^((n−1)/2).
   *
   * It has no yield stress. With n = 1 it is Newton's.
   */
  class PowerLaw : public FluidLaw
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
