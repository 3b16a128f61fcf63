// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_stabilization_h
#define lahar_assembly_stabilization_h

#include <lahar/assembly/fluid_cell.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * Stabilises the mass equation, which equal interpolation of velocity and pressure needs: terms of cells and of faces
   * on the free surface, with the parameter τ_s that FluidAssembler sets.
   *
   * A model of this kind registers itself with Factory<Stabilization<dim>>; its entries stand in the subsection of its
   * name in "Stabilization". One object serves a whole run.
   */
  template <int dim>
  class Stabilization
  {
  public:
    virtual ~Stabilization() = default;

    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// Whether FluidCell::residual_projection is wanted, see ResidualProjection; zero otherwise.
    virtual bool projects_residual() const
    {
      return false;
    }

    /// Add residual and derivatives of a cell.
    virtual void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const = 0;

    /// Add those of a face of the cell on the free surface.
    /// The number is that of the cell's node that the face does not have.
    virtual void assemble_free_surface(const FluidCell<dim> & /*cell*/, const unsigned int /*opposite*/,
                                       CellSystem<dim> & /*system*/) const
    {}
  };
} // namespace Lahar

#endif
