// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/bingham.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  void Bingham::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive(
      "Plastic viscosity", "0.001",
      "Plastic viscosity μ in Pa s, zero or above: the slope of stress over strain rate after yielding.");
    prm.declare_positive("Yield stress", "100",
                         "Yield stress τ0 in Pa, zero or above. Zero makes the fluid Newtonian.");
    prm.declare_positive(
      "Regularization parameter", "1000",
      "Papanastasiou's regularization parameter m in s, above zero. The unyielded fluid creeps with the "
      "viscosity μ + m τ0.");
  }



  void Bingham::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    mu    = prm.get_positive("Plastic viscosity", true);
    tau_0 = prm.get_positive("Yield stress", true);
    m     = prm.get_positive("Regularization parameter");
  }



  FluidLaw::Value Bingham::viscous_part(const double /*strain_rate*/) const
  {
    return {mu, 0.};
  }



  FluidLaw::Value Bingham::plastic_part(const double strain_rate) const
  {
    // Below z = m γ̇ = 1e-4 the series is exact to rounding in f and better than 1e-8 in f', where the closed form of
    // f' cancels.
    const double z = m * strain_rate;
    if (z < 1e-4)
      return {m * (1. - z / 2. * (1. - z / 3.)), -m * m * (0.5 - z / 3. + z * z / 8.)};

    const double yielded = -std::expm1(-z);
    return {yielded / strain_rate, (m * std::exp(-z) - yielded / strain_rate) / strain_rate};
  }



  static const Factory<FluidLaw>::Registration<Bingham>
    bingham("Bingham", "Plastic viscosity and a yield stress, regularised by Papanastasiou.");
} // namespace Lahar
