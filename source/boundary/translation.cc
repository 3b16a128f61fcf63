// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/boundary_motion.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/time_functions.h>
#include <lahar/utilities/vector_function.h>

namespace Lahar
{
  /// x = X + d(t).
  template <int dim>
  class Translation : public BoundaryMotion<dim>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Displacement", zero_function<dim>(), ';',
        "Displacement from where the shape is drawn, in m: functions of the time t in s, one per "
        "component, separated by ';', zero at 'Start time'. '0; 0.1 * min(max(t - 1, 0), 2)' lifts "
        "by 0.1 m/s from 1 s to 3 s.");
    }

    void parse_parameters(Parameters &prm) override
    {
      displacement = TimeFunctions(prm, "Displacement", dim);
    }

    RigidMotion<dim> at(const double time) const override
    {
      RigidMotion<dim> motion;
      const std::vector<double> values = displacement(time);
      for (unsigned int d = 0; d < dim; ++d)
        motion.shift[d] = values[d];
      return motion;
    }

  private:
    TimeFunctions displacement;
  };



  static const Factory<BoundaryMotion<2>>::Registration<Translation<2>>
    translation_2d("translation", "It is displaced by functions of the time.");
  static const Factory<BoundaryMotion<3>>::Registration<Translation<3>>
    translation_3d("translation", "It is displaced by functions of the time.");
} // namespace Lahar
