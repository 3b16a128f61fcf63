// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_newtonian_h
#define lahar_material_newtonian_h

#include <lahar/material/fluid_law.h>

namespace Lahar
{
  /// The Newtonian fluid, τ = 2 μ d'.
  class Newtonian : public FluidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    double mu = 0.;
  };
} // namespace Lahar

#endif
