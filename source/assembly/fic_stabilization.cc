// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/stabilization.h>
#include <lahar/assembly/terms.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// FICInterior and FICFreeSurface: does not keep the volume where the free surface accelerates.
  template <int dim>
  class FICStabilization : public Stabilization<dim>
  {
  public:
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const override
    {
      FICInterior<dim>().assemble(cell, system);
    }

    void assemble_free_surface(const FluidCell<dim> &cell, const unsigned int opposite,
                               CellSystem<dim> &system) const override
    {
      FICFreeSurface<dim>().assemble(cell, opposite, system);
    }
  };



  static const Factory<Stabilization<2>>::Registration<FICStabilization<2>>
    fic_2d("FIC", "Franci & Zhang 2018, with boundary terms on the free surface.");
  static const Factory<Stabilization<3>>::Registration<FICStabilization<3>>
    fic_3d("FIC", "Franci & Zhang 2018, with boundary terms on the free surface.");
} // namespace Lahar
