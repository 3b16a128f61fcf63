// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_volume_correction_h
#define lahar_remeshing_volume_correction_h

#include <lahar/boundary/walls.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>
#include <lahar/remeshing/old_domain.h>

#include <vector>

namespace Lahar
{
  /**
   * Takes back the volume that a remeshing has made or lost.
   *
   * The cells that the last mesh did not have and those that the new one does not have change the volume by
   * ΔV = Σ V(new) − Σ V(old); inside the fluid they cover the same region and the sum is zero. Each belongs to the
   * largest body that one of its fluid particles is in or, if none is left, of those that shared a cell with them. The
   * body's free surface gives ΔV back: with A_i the sum of the outward area vectors of the surface's faces at particle i
   * over their number of corners
   *
   *   x_i ← x_i − ΔV / (Σ_j |A_j|) A_i / |A_i|,
   *
   * which changes the volume by −ΔV to first order and keeps a level surface level. Particles on walls and solids stay,
   * and those of cells that touch them if there are others: they may be the front of the flow. No particle moves by
   * more than a tenth of its spacing, through an obstacle, or so far that a cell loses half of its volume: what cannot
   * be taken back remains, and is part of the statistics.
   */
  template <int dim>
  class VolumeCorrection
  {
  public:
    /**
     * Move the particles of the free surface of @p mesh, just made. Collective.
     *
     * @param old_domain the last mesh, renumbered to the particles of @p cloud.
     * @param walls rigid walls and contours of solids.
     */
    static void apply(const OldDomain<dim> &old_domain, const Walls<dim> &walls, FluidMesh<dim> &mesh,
                      ParticleCloud<dim> &cloud, const Migration<dim> &migration);
  };
} // namespace Lahar

#endif
