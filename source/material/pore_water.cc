// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/pore_water.h>

namespace Lahar
{
  void PoreWater::declare_parameters(Parameters &prm)
  {
    prm.declare_text(
      "Pore water level", "none",
      "Level in m up to which still water fills the pores, a height against the direction of "
      "gravity measured from the origin, or 'none'. Friction is that of the pressure above the "
      "hydrostatic one of this water.");
    prm.declare_positive("Pore water density", "1000",
                         "Density of the water in the pores in kg/m³, above zero and below 'Density', which "
                         "counts this water.");
  }



  void PoreWater::parse_parameters(const Parameters &prm, const double density)
  {
    rho_w                             = 0.;
    const std::optional<double> given = prm.get_number_or("Pore water level", "none");
    if (!given)
      return;
    level = *given;
    rho_w = prm.get_positive("Pore water density");
    if (rho_w >= density)
      prm.throw_wrong_value("Pore water density", "a number below the entry 'Density', " +
                                                    prm.get("Density") +
                                                    " kg/m³, which is that of grains and water together");
  }
} // namespace Lahar
