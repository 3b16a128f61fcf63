// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_fluid_h
#define lahar_initial_fluid_h

#include <deal.II/base/function_parser.h>

#include <lahar/geometry/fluid_shape.h>
#include <lahar/material/fluid_law.h>

#include <memory>
#include <string>

namespace Lahar
{
  /**
   * A named fluid of a case: where it is at the start, how fast, and its law.
   */
  template <int dim>
  class Fluid
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// Read the handler's current section, of the fluid's name. @throws InputError
    void parse_parameters(Parameters &prm, const std::string &name);

    /// Its bodies, with names as "'mud'" or "'mud' (number 2)" for messages.
    typename FluidShape<dim>::Bodies bodies() const
    {
      return shape->bodies("'" + name + "'");
    }

    /// At @p point at the start, m/s. @throws InputError if it is not finite.
    Tensor<1, dim> initial_velocity(const Point<dim> &point) const;

    std::string name;
    std::unique_ptr<FluidShape<dim>> shape;
    std::unique_ptr<FluidLaw> law;

  private:
    std::shared_ptr<FunctionParser<dim>> velocity;
    std::string velocity_path, velocity_text; ///< of the entry
  };
} // namespace Lahar

#endif
