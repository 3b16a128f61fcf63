// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/boundary_motion.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/time_functions.h>

#include <cmath>

namespace Lahar
{
  /// x = c + R(φ(t)) (X − c), R the rotation by φ about an axis (in the plane: that of z), right-handed.
  template <int dim>
  class Rotation : public BoundaryMotion<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_vector("Centre", dim == 2 ? "0, 0" : "0, 0, 0", dim, "A point of the axis, m.");
      if constexpr (dim == 3)
        prm.declare_vector("Axis", "0, 0, 1", dim, "Direction of the axis, of any length but zero.");
      prm.declare_text(
        "Angle", "0",
        dim == 2 ? "Angle in rad, counterclockwise: a function of the time t in s, zero at 'Start "
                   "time'. 'pi * t' is half a turn a second."
                 : "Angle in rad, right-handed about the axis: a function of the time t in s, zero at "
                   "'Start time'. 'pi * t' is half a turn a second.");
    }

    void parse_parameters(Parameters &prm) override
    {
      centre = Point<dim>(prm.get_vector<dim>("Centre"));
      angle  = TimeFunctions(prm, "Angle", 1);
      if constexpr (dim == 3)
      {
        axis = prm.get_vector<dim>("Axis");
        if (axis.norm() == 0.)
          prm.throw_wrong_value("Axis", "a direction, so not all components zero");
        axis /= axis.norm();
      }
    }

    RigidMotion<dim> at(const double time) const override
    {
      const double phi = angle(time)[0];
      RigidMotion<dim> motion;
      // Rodrigues: R x = cos φ x + sin φ a × x + (1 − cos φ) (a·x) a.
      for (unsigned int d = 0; d < dim; ++d)
      {
        Tensor<1, dim> e;
        e[d] = 1.;
        Tensor<1, dim> turned;
        if constexpr (dim == 2)
          turned = std::cos(phi) * e - std::sin(phi) * cross_product_2d(e);
        else
          turned = std::cos(phi) * e + std::sin(phi) * cross_product_3d(axis, e) +
                   (1. - std::cos(phi)) * (axis * e) * axis;
        for (unsigned int c = 0; c < dim; ++c)
          motion.rotation[c][d] = turned[c];
      }
      motion.shift = centre - Point<dim>(motion.rotation * centre);
      return motion;
    }

  private:
    Point<dim> centre;
    Tensor<1, dim> axis;
    TimeFunctions angle;
  };



  static const Factory<BoundaryMotion<2>>::Registration<Rotation<2>>
    rotation_2d("rotation", "It turns about a point by a function of the time.");
  static const Factory<BoundaryMotion<3>>::Registration<Rotation<3>>
    rotation_3d("rotation", "It turns about an axis by a function of the time.");
} // namespace Lahar
