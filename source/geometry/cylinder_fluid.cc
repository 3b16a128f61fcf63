// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/cone_body.h>
#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// A cylinder in any direction.
  class CylinderFluid : public FluidShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list("Ends", "", ':',
                       "Centres of the two ends 'x, y, z : x, y, z' in m, apart from each other.");
      prm.declare_positive("Radius", "0", "Radius in m, above zero.");
    }

    void parse_parameters(Parameters &prm) override
    {
      const std::string allowed = "the two ends 'x, y, z : x, y, z', apart from each other";
      ends                      = parse_points<3>(prm, "Ends", prm.get("Ends"), allowed);
      if (ends.size() != 2 || !(ends[0].distance(ends[1]) > 0.))
        prm.throw_wrong_value("Ends", allowed);
      radius = prm.get_positive("Radius");
    }

    Bodies bodies(const std::string &name) const override
    {
      Bodies result;
      result.push_back(std::make_unique<ConeBody>(name, ends[0], ends[1], radius, radius));
      return result;
    }

  private:
    std::vector<Point<3>> ends;
    double radius = 0.;
  };



  static const Factory<FluidShape<3>>::Registration<CylinderFluid> cylinder("cylinder",
                                                                            "A cylinder in any direction.");
} // namespace Lahar
