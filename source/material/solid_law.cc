// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/solid_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void SolidLaw::declare_parameters(Parameters &prm)
  {
    Factory<SolidLaw>::declare_models(prm, "Law", "hypoelastic", "Constitutive law of the solid.");
  }



  std::unique_ptr<SolidLaw> SolidLaw::create(Parameters &prm)
  {
    return Factory<SolidLaw>::create_chosen(prm, "Law");
  }



  void SolidLaw::declare_common_parameters(Parameters &prm)
  {
    prm.declare_positive("Density", "1000", "Density ρ of the undeformed solid in kg/m³, above zero.");
    prm.declare_positive("Young's modulus", "1e6", "Young's modulus E in Pa, above zero.");
    prm.declare_number("Poisson's ratio", "0", "Poisson's ratio ν, above -1 and below 0.5.", -1., 0.5);
  }



  void SolidLaw::parse_parameters(Parameters &prm)
  {
    rho     = prm.get_positive("Density");
    young   = prm.get_positive("Young's modulus");
    poisson = prm.get_number("Poisson's ratio");
    if (!(poisson > -1. && poisson < 0.5))
      prm.throw_wrong_value("Poisson's ratio", "a number above -1 and below 0.5");
  }
} // namespace Lahar
