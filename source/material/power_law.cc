// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/power_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void PowerLaw::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive("Consistency", "1", "Consistency K in Pa s^n, zero or above.");
    prm.declare_positive(
      "Flow index", "0.5",
      "Flow index n, above zero: below 1 the fluid thins with shear, above 1 it thickens.");
    RegularizedPower::declare_smallest_rate(prm);
  }



  void PowerLaw::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    const double consistency = prm.get_positive("Consistency", true);
    const double index       = prm.get_positive("Flow index");
    viscosity = RegularizedPower(consistency, index - 1., RegularizedPower::parse_smallest_rate(prm));
  }



  FluidLaw::Value PowerLaw::viscous_part(const double strain_rate, const double /*pressure*/) const
  {
    return viscosity(strain_rate);
  }



  static const Factory<FluidLaw>::Registration<PowerLaw>
    power_law("power law", "A power of the strain rate, without yield stress.");
} // namespace Lahar
