// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_interface_correction_h
#define lahar_remeshing_interface_correction_h

#include <lahar/geometry/walls.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>

#include <vector>

namespace Lahar
{
  /**
   * Gives back what fluids have taken from each other.
   *
   * With A_fg the area of the interface between fluids f and g, the sum over its movable particles, and e_f what f has too
   * much of, Σ e_f = 0, the interface moves towards f by δ_fg = λ_f − λ_g,
   *
   *   Σ_g A_fg (λ_f − λ_g) = e_f,
   *
   * each particle along the sum A_i of the area vectors of its faces: the smallest motion, in the sense of ∫ δ², that
   * changes all volumes by −e_f to first order. Particles of the free surface and those in contact with walls and solids
   * stay, as do those where three fluids meet. No particle moves by more than a tenth of its spacing, through an obstacle,
   * or so far that a cell loses half of its volume. Total volumes do not change.
   */
  template <int dim>
  class InterfaceCorrection
  {
  public:
    /**
     * Move the particles of the interfaces of @p mesh. Collective.
     *
     * @param excess e_f, m^dim, the same on all ranks; what fluids have too little of is negative.
     * @param walls rigid walls and contours of solids.
     */
    static void apply(const std::vector<double> &excess, const Walls<dim> &walls, FluidMesh<dim> &mesh,
                      ParticleCloud<dim> &cloud, const Migration<dim> &migration);
  };
} // namespace Lahar

#endif
