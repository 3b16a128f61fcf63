// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/grain_friction.h>

#include <cmath>

namespace Lahar
{
  void GrainFriction::declare_parameters(Parameters &prm)
  {
    prm.declare_positive("Grain density", "2500",
                         "Density ρ_s of the grains in kg/m³, not below 'Density', which counts the voids.");
    prm.declare_positive("Grain diameter", "0.001", "Diameter d_g of the grains in m, above zero.");
    prm.declare_number("Static friction", "0.38",
                       "Coefficient of friction μ_s in slow flow, above zero and below 'Dynamic friction'.",
                       0., 1.);
    prm.declare_number("Dynamic friction", "0.64",
                       "Coefficient of friction μ_d in rapid flow, above 'Static friction' and below 1.", 0.,
                       1.);
    prm.declare_positive("Reference inertial number", "0.279",
                         "I0, above zero: the inertial number at which friction is halfway between the two.");
  }



  void GrainFriction::parse_parameters(const Parameters &prm, const double density)
  {
    rho_s = prm.get_positive("Grain density");
    if (rho_s < density)
      prm.throw_wrong_value("Grain density", "a number that is not below the entry 'Density', " +
                                               prm.get("Density") +
                                               " kg/m³, which is that of grains and voids");
    d_g  = prm.get_positive("Grain diameter");
    mu_s = prm.get_positive("Static friction");
    mu_d = prm.get_positive("Dynamic friction");
    if (mu_s >= 1.)
      prm.throw_wrong_value("Static friction", "a number above 0 and below 1");
    if (!(mu_d > mu_s && mu_d < 1.))
      prm.throw_wrong_value("Dynamic friction", "a number above the entry 'Static friction', " +
                                                  prm.get("Static friction") +
                                                  ", and below 1, where grains would have to hold tension");
    I_0 = prm.get_positive("Reference inertial number");
  }



  double GrainFriction::inertial_number(const double strain_rate, const double pressure) const
  {
    return strain_rate * d_g / std::sqrt(pressure / rho_s);
  }



  double GrainFriction::reference_rate(const double pressure) const
  {
    return I_0 * std::sqrt(pressure / rho_s) / d_g;
  }



  GrainFriction::Value GrainFriction::friction(const double inertial_number, const double slope) const
  {
    const double part = inertial_number / (I_0 + inertial_number);
    const double mu   = mu_s + (mu_d - mu_s) * part + slope * inertial_number * part;
    return {mu, part * (mu_d + 2. * slope * inertial_number - mu) / mu};
  }



  bool GrainFriction::is_well_posed(const Value &friction)
  {
    const auto [mu, nu] = friction;
    const double root   = mu * (1. - nu / 2.);
    return 4. * nu * (nu - 1.) + root * root <= 0.;
  }
} // namespace Lahar
