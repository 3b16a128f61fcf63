// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/casson.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  void Casson::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive(
      "Casson viscosity", "0.001",
      "Viscosity μ_c in Pa s, zero or above, to which that of the fluid falls at high strain rates.");
    RegularizedPower::declare_smallest_rate(prm);
    declare_yield_stress(prm);
    declare_yield(prm, "μ_c + 2 √(τ0 μ_c/ε) + m τ0");
  }



  void Casson::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    mu = prm.get_positive("Casson viscosity", true);
    parse_yield_stress(prm);
    parse_yield(prm);
    parse_thixotropy(prm);
    mixed_part = RegularizedPower(2. * std::sqrt(tau_0 * mu), -0.5,
                                  RegularizedPower::parse_smallest_rate(prm));
  }



  FluidLaw::Value Casson::viscous_part(const double strain_rate, const double /*pressure*/) const
  {
    const Value mixed = mixed_part(strain_rate);
    return {mu + mixed.value, mixed.derivative};
  }



  static const Factory<FluidLaw>::Registration<Casson> casson(
    "Casson",
    "The root of the stress is a line over the root of the strain rate; a yield stress, regularised by "
    "Papanastasiou or exact.");
} // namespace Lahar
