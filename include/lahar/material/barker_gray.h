// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_barker_gray_h
#define lahar_material_barker_gray_h

#include <lahar/material/fluid_law.h>
#include <lahar/material/grain_friction.h>

namespace Lahar
{
  /**
   * Dry grains with the partially regularised friction of Barker & Gray (J. Fluid Mech. 828 (2017) 5), well-posed up to
   * large I:
   *
   *   μ(I) = (μ_s I0 + μ_d I + μ_∞ I²)/(I0 + I)  for I > I1,   μ(I) = sqrt(α/ln(A/I))  for I ≤ I1,
   *
   * I1 the least inertial number from which on the first is well-posed even for μ_∞ = 0 (GrainFriction::is_well_posed()), A
   * such that μ is continuous. μ → 0 for I → 0: there is no yield stress, and all of the stress is viscous,
   *
   *   μ_eff(γ̇, P) = μ_f + μ(I(γ̂, P)) P/γ̂,   γ̂ = sqrt(γ̇² + ε²).
   */
  class BarkerGray : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

    bool may_be_ill_posed() const override
    {
      return true;
    }

    bool is_well_posed(const double strain_rate, const double pressure) const override;

  private:
    GrainFriction::Value friction_at(const double inertial_number) const;

    GrainFriction grains;
    double mu_f = 0., mu_infinity = 0., alpha = 1., epsilon = 1.;
    double I_1 = 0., log_A = 0.; ///< I1, ln(A)
  };
} // namespace Lahar

#endif
