// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/stabilization.h>
#include <lahar/assembly/terms.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// ResidualStabilization without projection, π = 0.
  template <int dim>
  class UnprojectedStabilization : public Stabilization<dim>
  {
  public:
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const override
    {
      ResidualStabilization<dim>().assemble(cell, system);
    }
  };



  static const Factory<Stabilization<2>>::Registration<UnprojectedStabilization<2>>
    residual_2d("residual", "The full momentum residual in the gradient term; conserves volume.");
  static const Factory<Stabilization<3>>::Registration<UnprojectedStabilization<3>>
    residual_3d("residual", "The full momentum residual in the gradient term; conserves volume.");
} // namespace Lahar
