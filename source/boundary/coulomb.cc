// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The fluid sticks up to a shear stress c + μ_w N and slides beyond it with that resistance, N its normal stress.
  class Coulomb : public SurfaceLaw
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_positive(
        "Friction coefficient", "0.4",
        "μ_w, zero or above: shear stress over normal stress when the fluid slides, the tangent of the "
        "angle of friction.");
      prm.declare_positive("Cohesion", "0",
                           "c in Pa, zero or above: shear stress that needs no normal stress.");
    }

    void parse_parameters(Parameters &prm) override
    {
      mu       = prm.get_positive("Friction coefficient", true);
      cohesion = prm.get_positive("Cohesion", true);
    }

    bool lands() const override
    {
      return true;
    }

    bool resists() const override
    {
      return true;
    }

    Resistance resistance(const double normal_stress) const override
    {
      return {0., cohesion + mu * normal_stress, mu};
    }

  private:
    double mu = 0., cohesion = 0.;
  };



  static const Factory<SurfaceLaw>::Registration<Coulomb>
    coulomb("Coulomb", "Fluid sticks or slides by dry friction with cohesion.");
} // namespace Lahar
