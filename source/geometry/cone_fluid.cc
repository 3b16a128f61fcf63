// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/cone_body.h>
#include <lahar/geometry/fluid_shape.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// An upright truncated cone, not wider at its top than at its base.
  class ConeFluid : public FluidShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_vector("Base", "0, 0, 0", 3, "Centre of the base 'x, y, z' in m.");
      prm.declare_positive("Base radius", "0", "Radius of the base in m, above zero.");
      prm.declare_positive("Top radius", "0",
                           "Radius of the top in m, above zero, at most that of the base.");
      prm.declare_positive("Height", "0", "Height in m, above zero.");
    }

    void parse_parameters(Parameters &prm) override
    {
      base        = Point<3>(prm.get_vector<3>("Base"));
      base_radius = prm.get_positive("Base radius");
      top_radius  = prm.get_positive("Top radius");
      height      = prm.get_positive("Height");
      if (top_radius > base_radius)
        prm.throw_wrong_value("Top radius", "a number above zero and up to 'Base radius', which is " +
                                              prm.get("Base radius"));
    }

    Bodies bodies(const std::string &name) const override
    {
      Bodies result;
      result.push_back(std::make_unique<ConeBody>(name, base, base + Tensor<1, 3>({0., 0., height}),
                                                  base_radius, top_radius));
      return result;
    }

  private:
    Point<3> base;
    double base_radius = 0., top_radius = 0., height = 0.;
  };



  static const Factory<FluidShape<3>>::Registration<ConeFluid> cone("cone", "An upright truncated cone.");
} // namespace Lahar
