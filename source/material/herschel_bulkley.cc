// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/herschel_bulkley.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void HerschelBulkley::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive("Consistency", "1", "Consistency K in Pa s^n, zero or above.");
    prm.declare_positive(
      "Flow index", "0.5",
      "Flow index n, above zero: below 1 the fluid thins with shear, above 1 it thickens.");
    RegularizedPower::declare_smallest_rate(prm);
    declare_yield_stress(prm);
    declare_yield(prm, "K ε^(n−1) + m τ0");
  }



  void HerschelBulkley::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    const double consistency = prm.get_positive("Consistency", true);
    const double index       = prm.get_positive("Flow index");
    viscosity = RegularizedPower(consistency, index - 1., RegularizedPower::parse_smallest_rate(prm));
    parse_yield_stress(prm);
    parse_yield(prm);
    parse_thixotropy(prm);
  }



  FluidLaw::Value HerschelBulkley::viscous_part(const double strain_rate, const double /*pressure*/) const
  {
    return viscosity(strain_rate);
  }



  static const Factory<FluidLaw>::Registration<HerschelBulkley>
    herschel_bulkley("Herschel-Bulkley",
                     "A power of the strain rate and a yield stress, regularised by Papanastasiou or exact.");
} // namespace Lahar
