// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/convex_body.h>
#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Convex polyhedra in space.
  class ConvexFluid : public FluidShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Corners", "", ';',
        "Convex bodies, each as its corners 'x, y, z : x, y, z ...' in any order, separated by ';'. "
        "Lengths in m.");
    }

    void parse_parameters(Parameters &prm) override
    {
      corners = parse_point_lists<3>(prm, "Corners");
      if (corners.empty())
        prm.throw_wrong_value("Corners", "at least four corners that do not lie in a plane");
      try
      {
        bodies("");
      }
      catch (const InputError &error)
      {
        prm.throw_wrong_value("Corners", error.what());
      }
    }

    Bodies bodies(const std::string &name) const override
    {
      Bodies result;
      for (const std::vector<Point<3>> &body : corners)
        result.push_back(std::make_unique<ConvexBody>(body_name(name, result.size(), corners.size()), body));
      return result;
    }

  private:
    std::vector<std::vector<Point<3>>> corners; ///< by body
  };



  static const Factory<FluidShape<3>>::Registration<ConvexFluid> convex("convex",
                                                                        "Convex polyhedra by their corners.");
} // namespace Lahar
