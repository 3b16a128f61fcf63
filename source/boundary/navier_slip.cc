// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// t = −β s. Of a fluid of viscosity μ, μ/β is the slip length.
  class NavierSlip : public SurfaceLaw
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_positive(
        "Slip coefficient", "1000",
        "β in Pa s/m, above zero: shear stress over sliding velocity. A fluid of viscosity μ has the "
        "slip length μ/β.");
    }

    void parse_parameters(Parameters &prm) override
    {
      beta = prm.get_positive("Slip coefficient");
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
      return {beta, 0., 0.};
    }

  private:
    double beta = 0.;
  };



  static const Factory<SurfaceLaw>::Registration<NavierSlip>
    navier_slip("Navier slip", "Fluid slides; the surface resists in proportion to the velocity.");
} // namespace Lahar
