// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_solid_solid_body_h
#define lahar_solid_solid_body_h

#include <deal.II/base/function_parser.h>

#include <lahar/geometry/box.h>
#include <lahar/geometry/ground.h>
#include <lahar/geometry/solid_shape.h>
#include <lahar/material/solid_law.h>

#include <memory>
#include <optional>

namespace Lahar
{
  /**
   * One solid: shape, law, initial velocity and what holds, drives and loads its contour.
   *
   * Parts of the contour are named by boxes in the undeformed configuration: the nodes (for loads: the faces whose
   * middle) inside count.
   *
   * A solid that stands on a ground is drawn as if the ground were the plane of elevation zero: each of its vertices is
   * raised by the elevation of the ground under it. Boxes name parts of the drawing.
   */
  template <int dim>
  class SolidBody
  {
  public:
    /// What is prescribed for a part of the contour: a velocity or a traction as a function of X and time.
    struct Prescribed
    {
      std::vector<Box<dim>> where;
      std::shared_ptr<FunctionParser<dim>> function;
      std::string path, text; ///< of the entry with the boxes

      bool contains(const Point<dim> &point, const double tolerance) const;

      /// At @p point and @p time.
      Tensor<1, dim> value(const Point<dim> &point, const double time) const;
    };

    static void declare_parameters(Parameters &prm);

    /// Read the handler's current section, of the solid's name. @throws InputError
    void parse_parameters(Parameters &prm, const std::string &name);

    /// The smallest box around the shape where it stands.
    Box<dim> box() const
    {
      return ground ? ground->raised(shape->box()) : shape->box();
    }

    std::string name;
    std::unique_ptr<SolidShape<dim>> shape;
    std::optional<Ground<dim>> ground; ///< on which it stands
    std::unique_ptr<SolidLaw> law;
    Prescribed clamped;                                    ///< without a function
    Prescribed driven;                                     ///< velocity, m/s
    Prescribed loaded;                                     ///< force per undeformed area, Pa
    std::shared_ptr<FunctionParser<dim>> initial_velocity; ///< m/s
  };
} // namespace Lahar

#endif
