// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/boundary_shape.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Convex plane polygons in space.
  class PolygonBoundary : public BoundaryShape<3>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Corners", "", ';',
        "Convex polygons, each in a plane and as its corners 'x, y, z : x, y, z : x, y, z ...', "
        "separated by ';'. Lengths in m.");
    }

    void parse_parameters(Parameters &prm) override
    {
      for (const std::vector<Point<3>> &corners : parse_point_lists<3>(prm, "Corners"))
      {
        polygons.emplace_back();
        polygons.back().corners = corners;
        try
        {
          polygons.back().facets();
        }
        catch (const InputError &error)
        {
          prm.throw_wrong_value("Corners", std::string(error.what()) + " for each polygon (number " +
                                             std::to_string(polygons.size()) + ")");
        }
      }
      if (polygons.empty())
        prm.throw_wrong_value("Corners", "at least three corners in a plane");
    }

    std::vector<WallShape<3>> walls() const override
    {
      return polygons;
    }

  private:
    std::vector<WallShape<3>> polygons;
  };



  static const Factory<BoundaryShape<3>>::Registration<PolygonBoundary>
    polygon_boundary("polygon", "Convex plane polygons.");
} // namespace Lahar
