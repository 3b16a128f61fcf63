// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/physics/transformations.h>

#include <lahar/boundary/boundary_motion.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/time_functions.h>

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
      RigidMotion<dim> motion;
      if constexpr (dim == 2)
        motion.rotation = Physics::Transformations::Rotations::rotation_matrix_2d(angle(time)[0]);
      else
        motion.rotation = Physics::Transformations::Rotations::rotation_matrix_3d(axis, angle(time)[0]);
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
