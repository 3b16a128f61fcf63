// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/boundary_motion.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// x = X.
  template <int dim>
  class Fixed : public BoundaryMotion<dim>
  {
  public:
    bool moves() const override
    {
      return false;
    }

    RigidMotion<dim> at(const double /*time*/) const override
    {
      return {};
    }
  };



  static const Factory<BoundaryMotion<2>>::Registration<Fixed<2>> fixed_2d("fixed", "It stands.");
  static const Factory<BoundaryMotion<3>>::Registration<Fixed<3>> fixed_3d("fixed", "It stands.");
} // namespace Lahar
