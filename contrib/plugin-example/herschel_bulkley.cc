// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/fluid_law.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  /// The Herschel-Bulkley fluid regularised by Papanastasiou: μ(γ̇) = K γ̇^(n−1), f(γ̇) = (1 − exp(−m γ̇))/γ̇.
  class HerschelBulkley : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      declare_common_parameters(prm); // Density and Bulk modulus
      prm.declare_positive("Consistency", "1", "Consistency K in Pa s^n, zero or above.");
      prm.declare_number("Flow index", "0.5", "Flow index n, 0.1 to 2.", 0.1, 2.);
      prm.declare_positive("Yield stress", "100", "Yield stress τ0 in Pa, zero or above.");
      prm.declare_positive("Regularization parameter", "1000",
                           "Papanastasiou's regularization parameter m in s, above zero.");
      prm.declare_positive("Smallest strain rate", "1e-3",
                           "The viscous part is constant below this strain rate, 1/s, above zero.");
    }

    void parse_parameters(Parameters &prm) override
    {
      FluidLaw::parse_parameters(prm);
      K        = prm.get_positive("Consistency", true);
      n        = prm.get_in_range("Flow index", 0.1, 2.);
      tau_0    = prm.get_positive("Yield stress", true);
      m        = prm.get_positive("Regularization parameter");
      smallest = prm.get_positive("Smallest strain rate");
    }

    double yield_stress() const override
    {
      return tau_0;
    }

    Value viscous_part(const double strain_rate) const override
    {
      if (strain_rate < smallest)
        return {K * std::pow(smallest, n - 1.), 0.};
      const double mu = K * std::pow(strain_rate, n - 1.);
      return {mu, (n - 1.) * mu / strain_rate};
    }

    Value plastic_part(const double strain_rate) const override
    {
      const double z = m * strain_rate;
      if (z < 1e-4) // f(0) = m, f'(0) = −m²/2
        return {m * (1. - z / 2.), -m * m * (0.5 - z / 3.)};
      const double yielded = -std::expm1(-z);
      return {yielded / strain_rate, (m * std::exp(-z) - yielded / strain_rate) / strain_rate};
    }

  private:
    double K = 0., n = 1., tau_0 = 0., m = 0., smallest = 0.;
  };



  static const Factory<FluidLaw>::Registration<HerschelBulkley>
    herschel_bulkley("Herschel-Bulkley",
                     "A power of the strain rate and a yield stress, regularised by Papanastasiou.");
} // namespace Lahar
