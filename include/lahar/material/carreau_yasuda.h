// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_carreau_yasuda_h
#define lahar_material_carreau_yasuda_h

#include <lahar/material/fluid_law.h>

namespace Lahar
{
  /**
   * The fluid of Carreau (Trans. Soc. Rheol. 16 (1972) 99) and Yasuda, Armstrong & Cohen (Rheol. Acta 20 (1981) 163),
   * with a plateau of the viscosity at each end and a power law between them:
   *
   *   μ(γ̇) = μ_∞ + (μ_0 − μ_∞) [1 + (λ γ̇)^a]^((n−1)/a).
   *
   * a = 2 is Carreau's; λ = 0 or n = 1 is Newton's. μ_0 < μ_∞ thickens with shear. The stress grows with γ̇ for n ≤ 1,
   * and for n > 1 if μ_0 ≥ μ_∞; other entries are refused.
   */
  class CarreauYasuda : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    /// The derivative is 0 where γ̇ is: for a < 1 it has no limit there, but γ̇ times it has, 0.
    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    double mu_0 = 0., mu_infinity = 0., lambda = 0., n = 1., a = 2.;
  };
} // namespace Lahar

#endif
