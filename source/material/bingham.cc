// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/bingham.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void Bingham::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive(
      "Plastic viscosity", "0.001",
      "Plastic viscosity μ in Pa s, zero or above: the slope of stress over strain rate after yielding.");
    declare_yield_stress(prm);
    declare_yield(prm, "μ + m τ0");
  }



  void Bingham::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    mu = prm.get_positive("Plastic viscosity", true);
    parse_yield_stress(prm);
    parse_yield(prm);
    parse_thixotropy(prm);
  }



  FluidLaw::Value Bingham::viscous_part(const double /*strain_rate*/, const double /*pressure*/) const
  {
    return {mu, 0.};
  }



  static const Factory<FluidLaw>::Registration<Bingham>
    bingham("Bingham", "Plastic viscosity and a yield stress, regularised by Papanastasiou or exact.");
} // namespace Lahar
