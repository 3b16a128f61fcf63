// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_boundary_motion_h
#define lahar_boundary_boundary_motion_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  using namespace dealii;

  /// x → R x + s with a rotation R.
  template <int dim>
  struct RigidMotion
  {
    Tensor<2, dim> rotation = unit_symmetric_tensor<dim>();
    Tensor<1, dim> shift; ///< m

    Point<dim> operator()(const Point<dim> &point) const
    {
      return Point<dim>(rotation * point + shift);
    }

    RigidMotion inverse() const
    {
      return {transpose(rotation), -(transpose(rotation) * shift)};
    }

    /// First @p first, then this one.
    RigidMotion after(const RigidMotion &first) const
    {
      return {rotation * first.rotation, rotation * first.shift + shift};
    }
  };

  /**
   * How a rigid boundary moves: where each of its points is at any time.
   *
   * A model of this kind registers itself with Factory<BoundaryMotion<dim>>; its parameters stand in the subsection of
   * its name in that of the boundary.
   */
  template <int dim>
  class BoundaryMotion
  {
  public:
    virtual ~BoundaryMotion() = default;

    /// Read the motion's own subsection. @throws InputError
    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// Whether the boundary moves at all.
    virtual bool moves() const
    {
      return true;
    }

    /// From where the shape is drawn to where it is at @p time (s). @throws RunError if a function of the time is not
    /// finite.
    virtual RigidMotion<dim> at(const double time) const = 0;
  };
} // namespace Lahar

#endif
