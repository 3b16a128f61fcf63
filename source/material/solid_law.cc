// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/solid_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void SolidLaw::declare_parameters(Parameters &prm)
  {
    prm.declare_entry("Law", "hypoelastic", Patterns::Anything(),
                      "Constitutive law of the solid. " + Factory<SolidLaw>::descriptions() +
                        " Its parameters stand in the subsection of its name.");
    Factory<SolidLaw>::declare_parameters(prm);
  }



  std::unique_ptr<SolidLaw> SolidLaw::create(Parameters &prm)
  {
    if (!Factory<SolidLaw>::contains(prm.get("Law")))
      prm.throw_wrong_value("Law", Factory<SolidLaw>::names());
    return Factory<SolidLaw>::create(prm.get("Law"), prm);
  }



  void SolidLaw::declare_common_parameters(Parameters &prm)
  {
    prm.declare_entry("Density", "1000", Patterns::Anything(),
                      "Density ρ of the undeformed solid in kg/m³, above zero.");
    prm.declare_entry("Young's modulus", "1e6", Patterns::Anything(), "Young's modulus E in Pa, above zero.");
    prm.declare_entry("Poisson's ratio", "0", Patterns::Anything(),
                      "Poisson's ratio ν, above -1 and below 0.5.");
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
