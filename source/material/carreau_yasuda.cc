// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/carreau_yasuda.h>
#include <lahar/material/rate_powers.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  void CarreauYasuda::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive("Viscosity at rest", "1",
                         "Viscosity μ_0 in Pa s at low strain rates, zero or above.");
    prm.declare_positive(
      "Viscosity at high rates", "0",
      "Viscosity μ_∞ in Pa s to which that of the fluid tends at high strain rates, zero or above.");
    prm.declare_positive(
      "Time constant", "1",
      "Time λ in s, zero or above: the viscosity begins to change at the strain rate 1/λ.");
    prm.declare_positive("Flow index", "0.5",
                         "Flow index n of the power law between the two viscosities, above zero.");
    prm.declare_number(
      "Exponent of the bend", "2",
      "Yasuda's exponent a, 0.1 to 10: the larger, the sharper the bend at the strain rate 1/λ; 2 is "
      "Carreau's.",
      smallest_exponent, largest_exponent);
  }



  void CarreauYasuda::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    mu_0        = prm.get_positive("Viscosity at rest", true);
    mu_infinity = prm.get_positive("Viscosity at high rates", true);
    lambda      = prm.get_positive("Time constant", true);
    n           = prm.get_positive("Flow index");
    a           = prm.get_in_range("Exponent of the bend", smallest_exponent, largest_exponent);
    if (n > 1. && mu_0 < mu_infinity)
      prm.throw_wrong_value(
        "Flow index",
        "a number above 0 and at most 1 with 'Viscosity at rest' below 'Viscosity at high rates'; "
        "otherwise the viscosity would become negative");
  }



  FluidLaw::Value CarreauYasuda::viscous_part(const double strain_rate, const double /*pressure*/) const
  {
    if (strain_rate < no_rate)
      return {mu_0, 0.};
    // With z = (λ γ̇)^a the derivative is (n − 1) part/γ̇ z/(1 + z), whatever the size of z.
    const double z    = std::pow(lambda * strain_rate, a);
    const double part = (mu_0 - mu_infinity) * std::pow(1. + z, (n - 1.) / a);
    return {mu_infinity + part, (n - 1.) * part / strain_rate / (1. + 1. / z)};
  }



  static const Factory<FluidLaw>::Registration<CarreauYasuda>
    carreau_yasuda("Carreau-Yasuda",
                   "A power law between two constant viscosities, with a bend of chosen sharpness.");
} // namespace Lahar
