// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/convex_body.h>
#include <lahar/geometry/fluid_shape.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/geometry/polygon_body.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Boxes with edges along the axes.
  template <int dim>
  class BoxFluid : public FluidShape<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list("Corners", "", ';',
                       std::string("Boxes, each as two opposite corners ") +
                         (dim == 2 ? "'x, y : x, y'" : "'x, y, z : x, y, z'") +
                         ", separated by ';'. Lengths in m.");
    }

    void parse_parameters(Parameters &prm) override
    {
      const std::string allowed = std::string("two opposite corners with different x") +
                                  (dim == 2 ? " and different y" : ", y and z") + " for each box";
      for (const std::vector<Point<dim>> &p : parse_point_lists<dim>(prm, "Corners"))
      {
        bool has_volume = p.size() == 2;
        for (unsigned int d = 0; d < dim && has_volume; ++d)
          has_volume = p[0][d] != p[1][d];
        if (!has_volume)
          prm.throw_wrong_value("Corners", allowed);
        boxes.emplace_back(p[0], p[1]);
      }
      if (boxes.empty())
        prm.throw_wrong_value("Corners", allowed);
    }

    typename FluidShape<dim>::Bodies bodies(const std::string &name) const override;

  private:
    std::vector<Box<dim>> boxes;
  };



  template <int dim>
  typename FluidShape<dim>::Bodies BoxFluid<dim>::bodies(const std::string &name) const
  {
    typename FluidShape<dim>::Bodies result;
    for (const Box<dim> &box : boxes)
    {
      const std::string body = body_name(name, result.size(), boxes.size());
      if constexpr (dim == 2)
        result.push_back(std::make_unique<PolygonBody>(
          body, Polygon{box.lower, {box.upper[0], box.lower[1]}, box.upper, {box.lower[0], box.upper[1]}}));
      else
      {
        std::vector<Point<3>> corners;
        for (unsigned int c = 0; c < 8; ++c)
          corners.emplace_back((c & 1 ? box.upper : box.lower)[0], (c & 2 ? box.upper : box.lower)[1],
                               (c & 4 ? box.upper : box.lower)[2]);
        result.push_back(std::make_unique<ConvexBody>(body, corners));
      }
    }
    return result;
  }



  static const Factory<FluidShape<2>>::Registration<BoxFluid<2>> box_2d("box", "Rectangles.");
  static const Factory<FluidShape<3>>::Registration<BoxFluid<3>> box_3d("box", "Cuboids.");
} // namespace Lahar
