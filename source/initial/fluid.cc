// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/initial/fluid.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/vector_function.h>

#include <cmath>
#include <sstream>

namespace Lahar
{
  template <int dim>
  void Fluid<dim>::declare_parameters(Parameters &prm)
  {
    Factory<FluidShape<dim>>::declare_models(prm, "Shape", "", "Where the fluid is at the start.");
    FluidLaw::declare_parameters(prm);
    prm.declare_list(
      "Initial velocity", zero_function<dim>(), ';',
      "Velocity at the start in m/s: functions of the coordinates, one per component, separated by "
      "';'.");
  }



  template <int dim>
  void Fluid<dim>::parse_parameters(Parameters &prm, const std::string &new_name)
  {
    name          = new_name;
    shape         = Factory<FluidShape<dim>>::create_chosen(prm, "Shape");
    law           = FluidLaw::create(prm);
    velocity      = parse_vector_function<dim>(prm, "Initial velocity", false);
    velocity_path = prm.path("Initial velocity");
    velocity_text = prm.get("Initial velocity");
  }



  template <int dim>
  Tensor<1, dim> Fluid<dim>::initial_velocity(const Point<dim> &point) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
    {
      result[d] = velocity->value(point, d);
      if (!std::isfinite(result[d]))
      {
        std::ostringstream place;
        place << point;
        throw InputError("Parameter '" + velocity_path + "' is '" + velocity_text +
                         "', which is not finite at (" + place.str() +
                         ") m. Allowed: functions that are finite in the fluid.");
      }
    }
    return result;
  }



  template class Fluid<2>;
  template class Fluid<3>;
} // namespace Lahar
