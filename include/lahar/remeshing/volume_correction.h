// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_volume_correction_h
#define lahar_remeshing_volume_correction_h

#include <lahar/geometry/walls.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>
#include <lahar/remeshing/old_domain.h>

#include <map>
#include <vector>

namespace Lahar
{
  /**
   * Takes back the volume that a remeshing has made or lost.
   *
   * The cells that the last mesh did not have and those that the new one does not have change the volume by
   * ΔV = Σ V(new) − Σ V(old); inside the fluid they cover the same region and the sum is zero. Each belongs to the
   * largest body that one of its fluid particles is in or, if none is left, of those that shared a cell with them; an
   * isolated particle is a body of its own, which carries what it owes until it lands. What the mesh hands to volumes
   * outside of it, as the layers of fluid that comes in, counts with the body of the particle that holds it, so that the
   * cells that the mesh lacks are no loss. The body's free surface gives ΔV
   * back: with A_i the sum of the shares, see face_share(), of particle i in the outward area vectors of the surface's
   * faces
   *
   *   x_i ← x_i − ΔV / (Σ_j |A_j|) A_i / |A_i|,
   *
   * which changes the volume by −ΔV to first order and keeps a level surface level. Particles on walls and solids stay,
   * and those of cells that touch them if there are others: they may be the front of the flow. No particle moves by
   * more than a tenth of its spacing, through an obstacle, or so far that a cell loses half of its volume. What cannot be
   * taken back is owed: the particles of the body carry it in equal shares (ParticleCloud::owed_volume), and the next
   * remeshings try again.
   */
  template <int dim>
  class VolumeCorrection
  {
  public:
    /// Volumes that particles hold outside of the mesh, m^dim, by their numbers; this rank's own particles.
    using OutsideVolumes = std::map<std::uint64_t, double>;

    /// The volumes of the mesh's cells, where the particles are now.
    static std::vector<double> cell_volumes(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud);

    /// Let the particles owe what the cells of @p mesh, which had the volumes @p before, have gained since then.
    static void owe_growth(const FluidMesh<dim> &mesh, const std::vector<double> &before,
                           ParticleCloud<dim> &cloud);

    /// The volume that this rank's own isolated particles carry: of the cells that they had, and have no longer.
    static double carried_volume(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud);

    /// The same of each of @p n_fluids fluids; what is on an interface counts with the first of its fluids.
    static std::vector<double> carried_volumes(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                               const unsigned int n_fluids);

    /// Put particles back to their @p old_position that have moved so far that a cell keeps less than half of its volume.
    /// Collective.
    static void keep_cells(const FluidMesh<dim> &mesh, const std::vector<Point<dim>> &old_position,
                           ParticleCloud<dim> &cloud, const Migration<dim> &migration);

    /// Whether any particle owes volume. Collective.
    static bool is_any_owed(const ParticleCloud<dim> &cloud, const Migration<dim> &migration);

    /**
     * Move the particles of the free surface of @p mesh, just made. Collective.
     *
     * @param old_domain the last mesh, renumbered to the particles of @p cloud.
     * @param passed_on what particles hold outside of the new mesh more than outside of the last one: it is no change.
     * @param walls rigid walls and contours of solids.
     */
    static void apply(const OldDomain<dim> &old_domain, const OutsideVolumes &passed_on,
                      const Walls<dim> &walls, FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud,
                      const Migration<dim> &migration);
  };
} // namespace Lahar

#endif
