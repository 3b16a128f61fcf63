// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/polygon_body.h>
#include <lahar/utilities/factory.h>

#include <cmath>

namespace Lahar
{
  /// An ellipse with axes along x and y: a polygon of its area.
  class Ellipse : public FluidShape<2>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_vector("Centre", "0, 0", 2, "Centre 'x, y' in m.");
      prm.declare_vector("Half axes", "0, 0", 2, "Half axes along x and y in m, above zero.");
      prm.declare_count("Corners", "100", "Number of corners of the polygon, 3 to 10000.", 3, 10000);
    }

    void parse_parameters(Parameters &prm) override
    {
      centre    = prm.get_vector<2>("Centre");
      axes      = prm.get_vector<2>("Half axes");
      n_corners = prm.get_count("Corners", 3, 10000);
      if (!(axes[0] > 0. && axes[1] > 0.))
        prm.throw_wrong_value("Half axes", "two numbers above zero");
    }

    Bodies bodies(const std::string &name) const override
    {
      const double angle = 2. * numbers::PI / n_corners, factor = std::sqrt(angle / std::sin(angle));
      Polygon corners;
      for (unsigned int i = 0; i < n_corners; ++i)
        corners.emplace_back(centre[0] + factor * axes[0] * std::cos(i * angle),
                             centre[1] + factor * axes[1] * std::sin(i * angle));
      Bodies result;
      result.push_back(std::make_unique<PolygonBody>(name, corners));
      return result;
    }

  private:
    Tensor<1, 2> centre, axes;
    unsigned int n_corners = 0;
  };



  static const Factory<FluidShape<2>>::Registration<Ellipse> ellipse("ellipse",
                                                                     "An ellipse with axes along x and y.");
} // namespace Lahar
