// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/fluid_law.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  /// The Bingham fluid regularised as by Bercovier & Engelman (J. Comput. Phys. 36 (1980) 313): f(γ̇) = (γ̇² + ε²)^(−1/2).
  class BercovierEngelman : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      declare_common_parameters(prm); // Density and Bulk modulus
      prm.declare_positive("Plastic viscosity", "0.001", "Plastic viscosity μ in Pa s, zero or above.");
      prm.declare_positive("Yield stress", "100", "Yield stress τ0 in Pa, zero or above.");
      prm.declare_positive(
        "Regularization strain rate", "1e-3",
        "Strain rate ε in 1/s, above zero; the unyielded fluid creeps with the viscosity μ + τ0/ε.");
    }

    void parse_parameters(Parameters &prm) override
    {
      FluidLaw::parse_parameters(prm);
      mu      = prm.get_positive("Plastic viscosity", true);
      tau_0   = prm.get_positive("Yield stress", true);
      epsilon = prm.get_positive("Regularization strain rate");
    }

    Value yield_stress(const double /*pressure*/) const override
    {
      return {tau_0};
    }

    Value viscous_part(const double /*strain_rate*/, const double /*pressure*/) const override
    {
      return {mu, 0.};
    }

    Value plastic_part(const double strain_rate) const override
    {
      const double f = 1. / std::hypot(strain_rate, epsilon);
      return {f, -strain_rate * f * f * f};
    }

  private:
    double mu = 0., tau_0 = 0., epsilon = 1.;
  };



  static const Factory<FluidLaw>::Registration<BercovierEngelman>
    bercovier_engelman("Bercovier-Engelman",
                       "Plastic viscosity and a yield stress, regularised by a small strain rate.");
} // namespace Lahar
