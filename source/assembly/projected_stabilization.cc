// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/stabilization.h>
#include <lahar/assembly/terms.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// ResidualStabilization with π of the start of the step, see ResidualProjection.
  template <int dim>
  class ProjectedStabilization : public Stabilization<dim>
  {
  public:
    bool projects_residual() const override
    {
      return true;
    }

    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const override
    {
      ResidualStabilization<dim>().assemble(cell, system);
    }
  };



  static const Factory<Stabilization<2>>::Registration<ProjectedStabilization<2>> projected_residual_2d(
    "projected residual",
    "Of the residual only what cells differ by from their neighbours, so that stress in fluid at rest drives no flow.");
  static const Factory<Stabilization<3>>::Registration<ProjectedStabilization<3>> projected_residual_3d(
    "projected residual",
    "Of the residual only what cells differ by from their neighbours, so that stress in fluid at rest drives no flow.");
} // namespace Lahar
