// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/fluid_law.h>
#include <lahar/utilities/factory.h>

#include <cmath>
#include <stdexcept>

namespace Lahar
{
  FluidLaw::Value FluidLaw::plastic_part(const double /*strain_rate*/) const
  {
    return {};
  }



  FluidLaw::Value FluidLaw::effective_viscosity(const double strain_rate, const double pressure,
                                                const double structure) const
  {
    const Value viscous = viscous_part(strain_rate, pressure);
    const Value plastic = plastic_part(strain_rate);
    const Value tau_y   = structured_yield_stress(pressure, structure);
    return {viscous.value + tau_y.value * plastic.value,
            viscous.derivative + tau_y.value * plastic.derivative,
            viscous.pressure_derivative + tau_y.pressure_derivative * plastic.value};
  }



  bool FluidLaw::is_yielded(const double strain_rate, const double pressure, const double structure) const
  {
    const double tau_y = structured_yield_stress(pressure, structure).value;
    return tau_y == 0. || effective_viscosity(strain_rate, pressure, structure).value * strain_rate > tau_y;
  }



  void FluidLaw::declare_parameters(Parameters &prm)
  {
    Factory<FluidLaw>::declare_models(prm, "Law", "Bingham", "Constitutive law of the fluid.");
  }



  std::unique_ptr<FluidLaw> FluidLaw::create(Parameters &prm)
  {
    return Factory<FluidLaw>::create_chosen(prm, "Law");
  }



  void FluidLaw::declare_common_parameters(Parameters &prm)
  {
    prm.declare_positive("Density", "1000", "Density ρ in kg/m³, above zero.");
    prm.declare_text("Bulk modulus", "infinite",
                     "Bulk modulus κ in Pa, above zero, or 'infinite' for an incompressible fluid.");
  }



  void FluidLaw::parse_parameters(Parameters &prm)
  {
    rho                                      = prm.get_positive("Density");
    const std::optional<double> bulk_modulus = prm.get_positive_or("Bulk modulus", "infinite");
    inverse_bulk_modulus                     = bulk_modulus ? 1. / *bulk_modulus : 0.;
  }
} // namespace Lahar
