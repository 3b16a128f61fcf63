// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_mu_of_i_h
#define lahar_material_mu_of_i_h

#include <lahar/material/grain_friction.h>
#include <lahar/material/yield_stress_law.h>

namespace Lahar
{
  /**
   * Dry grains with the friction μ(I) of GrainFriction, a cohesion c and a viscosity μ_f. The stress parts exactly into
   *
   *   τ_y(P) = c + μ_s P,   μ(γ̇, P) = μ_f + (μ_d − μ_s) P/(a + γ̇),   a = I0 sqrt(P/ρ_s)/d_g,
   *
   * of which the second needs no regularisation: at rest it is μ_f + (μ_d − μ_s) d_g sqrt(ρ_s P)/I0. The first is
   * regularised by Papanastasiou.
   */
  class MuOfI : public YieldStressLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

    bool may_be_ill_posed() const override
    {
      return true;
    }

    /// By GrainFriction; c and μ_f count as zero. What has not yielded and what no pressure holds are left out: yes.
    bool is_well_posed(const double strain_rate, const double pressure) const override;

  private:
    GrainFriction grains;
    double mu_f = 0.;
  };
} // namespace Lahar

#endif
