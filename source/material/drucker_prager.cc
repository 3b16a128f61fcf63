// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/numbers.h>

#include <lahar/material/drucker_prager.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    constexpr double right_angle = 90.; ///< in degrees
  }



  void DruckerPrager::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    prm.declare_positive("Cohesion", "0",
                         "Cohesion c in Pa, zero or above: the shear stress that the fluid bears in a plane "
                         "without pressure on it.");
    prm.declare_number("Friction angle", "30",
                       "Angle of internal friction φ in degrees, zero or above and below 90.", 0.,
                       right_angle);
    prm.declare_positive(
      "Viscosity", "0.001",
      "Viscosity μ in Pa s, zero or above: the slope of stress over strain rate after yielding.");
    PoreWater::declare_parameters(prm);
    declare_regularization(prm, "μ + m τ_y");
  }



  void DruckerPrager::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    const double cohesion = prm.get_positive("Cohesion", true);
    const double angle    = prm.get_number("Friction angle");
    if (!(angle >= 0. && angle < right_angle))
      prm.throw_wrong_value("Friction angle", "an angle in degrees, zero or above and below 90");
    tau_0    = cohesion * std::cos(angle * numbers::PI / 180.);
    friction = std::sin(angle * numbers::PI / 180.);
    mu       = prm.get_positive("Viscosity", true);
    water.parse_parameters(prm, density());
    parse_regularization(prm);
  }



  FluidLaw::Value DruckerPrager::viscous_part(const double /*strain_rate*/, const double /*pressure*/) const
  {
    return {mu};
  }



  static const Factory<FluidLaw>::Registration<DruckerPrager>
    drucker_prager("Drucker-Prager",
                   "Cohesion, friction that grows with the pressure, and a viscosity, regularised by "
                   "Papanastasiou.");
} // namespace Lahar
