// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/barker_gray.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    constexpr double largest_alpha = 2.;

    // Where I1 is looked for.
    constexpr double lowest_I = 1e-8, highest_I = 1e3, I_factor = 1.02;
  } // namespace



  void BarkerGray::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    GrainFriction::declare_parameters(prm);
    PoreWater::declare_parameters(prm);
    prm.declare_positive("Friction slope", "0.05",
                         "Growth μ_∞ of friction with the inertial number in rapid flow, zero or above.");
    prm.declare_number("Creep exponent", "1.9",
                       "α, above 0 and below 2: in slow creep the logarithm of 1/I is α/μ².", 0.,
                       largest_alpha);
    prm.declare_positive(
      "Viscosity", "0",
      "Viscosity μ_f in Pa s, zero or above, that is added where there is pressure and where "
      "there is none.");
    prm.declare_positive(
      "Smallest strain rate", "0.01",
      "Strain rate ε in 1/s, above zero, below which the viscosity is nearly constant. With less than "
      "0.001 Newton's method may fail.");
  }



  void BarkerGray::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    grains.parse_parameters(prm, density());
    water.parse_parameters(prm, density());
    mu_infinity = prm.get_positive("Friction slope", true);
    alpha       = prm.get_positive("Creep exponent");
    if (alpha >= largest_alpha)
      prm.throw_wrong_value("Creep exponent", "a number above 0 and below 2, where creep would be ill-posed");
    mu_f    = prm.get_positive("Viscosity", true);
    epsilon = prm.get_positive("Smallest strain rate");

    // From below to where it is well-posed, then between the last two.
    double upper = lowest_I;
    while (upper < highest_I && !GrainFriction::is_well_posed(grains.friction(upper)))
      upper *= I_factor;
    if (upper >= highest_I)
      prm.throw_wrong_value(
        "Dynamic friction",
        "a number so far above 'Static friction' that there are inertial numbers at which the "
        "flow is well-posed");
    double lower = upper / I_factor;
    while (upper - lower > 1e-15 * upper)
    {
      const double middle = 0.5 * (lower + upper);
      if (middle <= lower || middle >= upper)
        break;
      (GrainFriction::is_well_posed(grains.friction(middle)) ? upper : lower) = middle;
    }
    I_1              = upper;
    const double mu1 = grains.friction(I_1, mu_infinity).mu;
    log_A            = std::log(I_1) + alpha / (mu1 * mu1);
  }



  GrainFriction::Value BarkerGray::friction_at(const double inertial_number) const
  {
    if (inertial_number > I_1)
      return grains.friction(inertial_number, mu_infinity);
    const double mu = std::sqrt(alpha / (log_A - std::log(inertial_number)));
    return {mu, mu * mu / (2. * alpha)};
  }



  FluidLaw::Value BarkerGray::viscous_part(const double strain_rate, const double pressure) const
  {
    if (!(pressure > 0.))
      return {mu_f};
    const double rate   = std::hypot(strain_rate, epsilon);
    const auto [mu, nu] = friction_at(grains.inertial_number(rate, pressure));
    return {mu_f + mu * pressure / rate, mu * (nu - 1.) * pressure / rate / rate * (strain_rate / rate),
            mu / rate * (1. - nu / 2.)};
  }



  bool BarkerGray::is_well_posed(const double strain_rate, const double pressure) const
  {
    return !(pressure > 0.) || !(strain_rate > epsilon) ||
           GrainFriction::is_well_posed(friction_at(grains.inertial_number(strain_rate, pressure)));
  }



  static const Factory<FluidLaw>::Registration<BarkerGray>
    barker_gray("mu(I) Barker-Gray",
                "Dry grains as in 'mu(I)', with the partial regularisation of Barker and Gray: they creep.");
} // namespace Lahar
