#ifndef lahar_remeshing_volume_correction_h
#define lahar_remeshing_volume_correction_h

#include <lahar/boundary/walls.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/old_domain.h>

#include <vector>

namespace Lahar
{
  /**
   * Takes back the volume that a remeshing has made or lost.
   *
   * Cells that the last mesh did not have, and cells that the new one does not have, are joined across their common
   * faces to patches. A patch of the inside covers the same region before and after and changes no volume; one at the
   * free surface or at a contact changes it by δV = Σ V(new) − Σ V(old), and the sum over all patches is the mesh's
   * change. The free surface of the body that a patch belongs to gives δV back: with A_i the sum of the outward area
   * vectors of the surface's faces at particle i over their number of corners, and ΔV the sum over the body's patches,
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
     * Move the particles of the free surface of @p mesh, just made.
     *
     * @param old_domain the last mesh, renumbered to the particles of @p cloud.
     * @param walls rigid walls and contours of solids.
     */
    static void apply(const OldDomain<dim> &old_domain, const Walls<dim> &walls, FluidMesh<dim> &mesh,
                      ParticleCloud<dim> &cloud);
  };
} // namespace Lahar

#endif
