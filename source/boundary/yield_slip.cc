// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// The fluid sticks up to a shear stress τ_c, the sliding yield stress; beyond it t = −(τ_c s/|s| + β s).
  class YieldSlip : public SurfaceLaw
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_positive("Sliding yield stress", "10",
                           "τ_c in Pa, above zero: the shear stress at which fluid begins to slide.");
      prm.declare_positive("Slip coefficient", "0",
                           "β in Pa s/m, zero or above: further shear stress over sliding velocity.");
    }

    void parse_parameters(Parameters &prm) override
    {
      tau_c = prm.get_positive("Sliding yield stress");
      beta  = prm.get_positive("Slip coefficient", true);
    }

    bool lands() const override
    {
      return true;
    }

    bool resists() const override
    {
      return true;
    }

    Resistance resistance(const double /*normal_stress*/) const override
    {
      return {beta, tau_c, 0.};
    }

  private:
    double tau_c = 0., beta = 0.;
  };



  static const Factory<SurfaceLaw>::Registration<YieldSlip>
    yield_slip("yield slip", "Fluid sticks up to a shear stress and slides beyond it.");
} // namespace Lahar
