// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/stabilization.h>
#include <lahar/assembly/terms.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// FICInterior alone.
  template <int dim>
  class FICInteriorStabilization : public Stabilization<dim>
  {
  public:
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const override
    {
      FICInterior<dim>().assemble(cell, system);
    }
  };



  static const Factory<Stabilization<2>>::Registration<FICInteriorStabilization<2>>
    fic_interior_2d("FIC interior", "The same as 'FIC' without the boundary terms.");
  static const Factory<Stabilization<3>>::Registration<FICInteriorStabilization<3>>
    fic_interior_3d("FIC interior", "The same as 'FIC' without the boundary terms.");
} // namespace Lahar
