// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/cross.h>
#include <lahar/material/rate_powers.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  void Cross::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive("Viscosity at rest", "1",
                         "Viscosity μ_0 in Pa s at low strain rates, zero or above.");
    prm.declare_positive(
      "Viscosity at high rates", "0",
      "Viscosity μ_∞ in Pa s to which that of the fluid tends at high strain rates, zero or above.");
    prm.declare_positive(
      "Time constant", "1",
      "Time k in s, zero or above: at the strain rate 1/k the viscosity is halfway between the two.");
    prm.declare_number(
      "Exponent", "0.5",
      "Exponent q, 0.1 to 10, of the power law between the two viscosities; q = 1 − n, n that power "
      "law's flow index. Above 1 the viscosity at high rates must be large enough for the stress to grow "
      "with the strain rate.",
      smallest_exponent, largest_exponent);
  }



  void Cross::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    mu_0        = prm.get_positive("Viscosity at rest", true);
    mu_infinity = prm.get_positive("Viscosity at high rates", true);
    k           = prm.get_positive("Time constant", true);
    q           = prm.get_in_range("Exponent", smallest_exponent, largest_exponent);
    if (q > 1. && mu_infinity < (mu_0 - mu_infinity) * (q - 1.) * (q - 1.) / (4. * q))
      prm.throw_wrong_value(
        "Exponent", "a number from 0.1 to 1, or a 'Viscosity at high rates' with which the stress grows with "
                    "the strain rate");
  }



  FluidLaw::Value Cross::viscous_part(const double strain_rate, const double /*pressure*/) const
  {
    if (strain_rate < no_rate)
      return {mu_0, 0.};
    // With z = (k γ̇)^q the derivative is −q part/γ̇ z/(1 + z), whatever the size of z.
    const double z    = std::pow(k * strain_rate, q);
    const double part = (mu_0 - mu_infinity) / (1. + z);
    return {mu_infinity + part, -q * part / strain_rate / (1. + 1. / z)};
  }



  static const Factory<FluidLaw>::Registration<Cross>
    cross("Cross",
          "A viscosity that changes from one constant value to another with a power of the strain rate.");
} // namespace Lahar
