// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/mu_of_i.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void MuOfI::declare_parameters(Parameters &prm)
  {
    declare_common_parameters(prm);
    GrainFriction::declare_parameters(prm);
    PoreWater::declare_parameters(prm);
    prm.declare_positive("Cohesion", "0",
                         "Cohesion c in Pa, zero or above, the yield stress without pressure.");
    prm.declare_positive(
      "Viscosity", "0",
      "Viscosity μ_f in Pa s, zero or above, that is added where there is pressure and where "
      "there is none.");
    declare_regularization(prm, "μ_f + (μ_d − μ_s) d_g √(ρ_s P)/I0 + m τ_y");
  }



  void MuOfI::parse_parameters(Parameters &prm)
  {
    FluidLaw::parse_parameters(prm);
    grains.parse_parameters(prm, density());
    water.parse_parameters(prm, density());
    tau_0    = prm.get_positive("Cohesion", true);
    friction = grains.static_friction();
    mu_f     = prm.get_positive("Viscosity", true);
    parse_regularization(prm);
  }



  FluidLaw::Value MuOfI::viscous_part(const double strain_rate, const double pressure) const
  {
    const double a = grains.reference_rate(pressure), rate = a + strain_rate;
    if (!(rate > 0.))
      return {mu_f};
    const double mu = (grains.dynamic_friction() - grains.static_friction()) / rate;
    return {mu_f + mu * pressure, -mu * pressure / rate, mu * (a / 2. + strain_rate) / rate};
  }



  bool MuOfI::is_well_posed(const double strain_rate, const double pressure) const
  {
    return !(pressure > 0.) || !is_yielded(strain_rate, pressure) ||
           GrainFriction::is_well_posed(grains.friction(grains.inertial_number(strain_rate, pressure)));
  }



  static const Factory<FluidLaw>::Registration<MuOfI>
    mu_of_i("mu(I)",
            "Dry grains: friction that grows with the pressure and the inertial number, regularised by "
            "Papanastasiou.");
} // namespace Lahar
