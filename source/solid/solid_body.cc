// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/solid/solid_body.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/vector_function.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  bool SolidBody<dim>::Prescribed::contains(const Point<dim> &point, const double tolerance) const
  {
    return std::any_of(where.begin(), where.end(),
                       [&](const Box<dim> &box) { return box.contains(point, tolerance); });
  }



  template <int dim>
  Tensor<1, dim> SolidBody<dim>::Prescribed::value(const Point<dim> &point, const double time) const
  {
    Tensor<1, dim> result;
    function->set_time(time);
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = function->value(point, d);
    return result;
  }



  template <int dim>
  void SolidBody<dim>::declare_parameters(Parameters &prm)
  {
    const std::string zero = zero_function<dim>(), boxes = ", by boxes in the undeformed configuration: ",
                      corners = dim == 2 ? "'x, y : x, y'" : "'x, y, z : x, y, z'",
                      by      = boxes + corners + " separated by ';'";
    Factory<SolidShape<dim>>::declare_models(prm, "Shape", "", "The undeformed solid.");
    prm.declare_text(
      "Ground", "",
      "A boundary of the shape 'terrain' on which the solid stands: the shape is drawn as if its ground "
      "were the plane of elevation zero, and raised, point by point, by the elevation under it. "
      "Boxes as in 'Clamped' are those of the drawing.");
    prm.declare_list("Clamped", "", ';', "Part of the contour that does not move" + by + ".");
    prm.declare_list("Driven", "", ';', "Part of the contour with a given motion" + by + ".");
    prm.declare_list("Driving velocity", zero, ';',
                     "Velocity of the driven part in m/s: functions of the undeformed coordinates and of the "
                     "time t, one per component, separated by ';'.");
    prm.declare_list("Loaded", "", ';', "Part of the contour with a given load" + by + ".");
    prm.declare_list(
      "Traction", zero, ';',
      "Force per undeformed area on the loaded part in Pa, functions as in 'Driving velocity'. "
      "It keeps its direction when the solid turns.");
    prm.declare_list(
      "Initial velocity", zero, ';',
      "Initial velocity in m/s, functions of the coordinates, one per component, separated by ';'.");
    SolidLaw::declare_parameters(prm);
  }



  template <int dim>
  void SolidBody<dim>::parse_parameters(Parameters &prm, const std::string &new_name)
  {
    name  = new_name;
    shape = Factory<SolidShape<dim>>::create_chosen(prm, "Shape");
    if (!prm.get("Ground").empty())
      ground.emplace(prm, "Ground", name);
    const auto prescribed = [&prm](const std::string &where, std::shared_ptr<FunctionParser<dim>> function) {
      return Prescribed{parse_boxes<dim>(prm, where), std::move(function), prm.path(where), prm.get(where)};
    };
    clamped          = prescribed("Clamped", nullptr);
    driven           = prescribed("Driven", parse_vector_function<dim>(prm, "Driving velocity", true));
    loaded           = prescribed("Loaded", parse_vector_function<dim>(prm, "Traction", true));
    initial_velocity = parse_vector_function<dim>(prm, "Initial velocity", true);
    law              = SolidLaw::create(prm);
  }



  template class SolidBody<2>;
  template class SolidBody<3>;
} // namespace Lahar
