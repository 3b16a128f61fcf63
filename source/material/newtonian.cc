// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/newtonian.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void Newtonian::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive("Viscosity", "0.001", "Dynamic viscosity μ in Pa s, zero or above.");
  }



  void Newtonian::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    mu = prm.get_positive("Viscosity", true);
  }



  FluidLaw::Value Newtonian::viscous_part(const double /*strain_rate*/, const double /*pressure*/) const
  {
    return {mu, 0.};
  }



  static const Factory<FluidLaw>::Registration<Newtonian> newtonian("Newtonian", "A constant viscosity.");
} // namespace Lahar
