// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/regularized_power.h>

#include <cmath>

namespace Lahar
{
  FluidLaw::Value RegularizedPower::operator()(const double strain_rate) const
  {
    const double rate  = std::hypot(strain_rate, smallest_rate);
    const double value = factor * std::pow(rate, exponent);
    return {value, exponent * value * (strain_rate / rate) / rate};
  }



  void RegularizedPower::declare_smallest_rate(Parameters &prm)
  {
    prm.declare_positive("Smallest strain rate", "1e-4",
                         "Strain rate ε in 1/s, above zero, below which the viscous part is nearly constant; "
                         "choose it far below the strain rates that matter.");
  }



  double RegularizedPower::parse_smallest_rate(const Parameters &prm)
  {
    return prm.get_positive("Smallest strain rate");
  }
} // namespace Lahar
