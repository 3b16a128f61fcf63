// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_drucker_prager_h
#define lahar_material_drucker_prager_h

#include <lahar/material/yield_stress_law.h>

namespace Lahar
{
  /**
   * A fluid that resists by cohesion and friction, after Drucker & Prager (Quart. Appl. Math. 10 (1952) 157), with
   * Papanastasiou's regularisation:
   *
   *   τ_y(P) = c cos φ + P sin φ,   μ_eff(γ̇, P) = μ + τ_y(P) (1 − exp(−m γ̇)) / γ̇.
   *
   * In plane strain without change of volume the deviator's out-of-plane component is zero, the principal stresses in the
   * plane are −P ± |τ|, and this is the criterion of Mohr and Coulomb with cohesion c and angle of friction φ. In space it
   * is the cone that meets Mohr and Coulomb's pyramid there. φ = 0 is Bingham's fluid with τ0 = c.
   */
  class DruckerPrager : public YieldStressLaw
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
