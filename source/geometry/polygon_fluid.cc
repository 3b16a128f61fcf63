// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/geometry/polygon_body.h>
#include <lahar/utilities/factory.h>

#include <algorithm>

namespace Lahar
{
  /// Polygons in the plane.
  class PolygonFluid : public FluidShape<2>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Corners", "", ';',
        "Polygons, each as its corners 'x, y : x, y : x, y ...', separated by ';'. Lengths in m.");
    }

    void parse_parameters(Parameters &prm) override
    {
      polygons                  = parse_point_lists<2>(prm, "Corners");
      const std::string allowed = "at least three corners and edges that do not meet each other";
      if (polygons.empty())
        prm.throw_wrong_value("Corners", allowed);
      for (Polygon &corners : polygons)
      {
        if (corners.size() < 3 || is_self_intersecting(corners) || signed_area(corners) == 0.)
          prm.throw_wrong_value("Corners", allowed);
        if (signed_area(corners) < 0.)
          std::reverse(corners.begin(), corners.end());
      }
    }

    Bodies bodies(const std::string &name) const override
    {
      Bodies result;
      for (const Polygon &corners : polygons)
        result.push_back(
          std::make_unique<PolygonBody>(body_name(name, result.size(), polygons.size()), corners));
      return result;
    }

  private:
    std::vector<Polygon> polygons; ///< counterclockwise
  };



  static const Factory<FluidShape<2>>::Registration<PolygonFluid> polygon_fluid("polygon",
                                                                                "Polygons by their corners.");
} // namespace Lahar
