// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_remesher_h
#define lahar_remeshing_remesher_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/alpha_shape.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>
#include <lahar/remeshing/particle_spacing.h>
#include <lahar/remeshing/volume_correction.h>
#include <lahar/utilities/parameters.h>

#include <functional>

namespace Lahar
{
  /**
   * Remeshing (PFEM): adapt the particles' spacing, triangulate them by Delaunay, keep what AlphaShape accepts,
   * take back what that changed of the volume (VolumeCorrection).
   *
   * Each rank finds the cells that are its own (local_delaunay()); then those near to the regions of other ranks go to
   * these (Migration). All decisions follow from what is near, so any number of ranks comes to the same mesh.
   */
  template <int dim>
  class Remesher
  {
  public:
    using Facet = std::array<unsigned int, dim>;

    /// Whether a simplex of particles belongs to a region.
    using Region = std::function<bool(const Simplex<dim> &, const ParticleCloud<dim> &)>;

    /// What this rank's own particles hold outside of a mesh, see VolumeCorrection.
    using OutsideVolumes = typename VolumeCorrection<dim>::OutsideVolumes;
    using FindOutside    = std::function<OutsideVolumes(const ParticleCloud<dim> &, const FluidMesh<dim> &)>;

    /// What a remeshing did.
    struct Report
    {
      bool changed = false; ///< the connectivity
      unsigned int n_forced =
        0; ///< this rank's facets of solids' contours that its Delaunay triangulation did not have
      std::vector<bool> arrives; ///< by vertex: whether it is a corner of a cell that was no fluid before
    };

    /// Whether changes of volume are taken back, see VolumeCorrection.
    bool keeps_volume() const
    {
      return keep_volume;
    }

    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// Of the case; one by default.
    void set_number_of_fluids(const unsigned int n)
    {
      n_fluids = n;
      particle_spacing.set_number_of_fluids(n);
    }

    /// What passes between the mesh and the volumes outside of it, which @p find finds, is no change of the volume.
    void set_outside_volumes(const FindOutside &find)
    {
      find_outside = find;
    }

    /**
     * How far beyond its own particles a rank must know particles and cells, m: Delaunay simplices of own particles have
     * corners within AlphaShape::reach(), whose old cells, and the cells around these, say what was fluid; and a step
     * needs two layers of cells around own particles. @p longest_other_edge is that of solids' cells. Collective.
     */
    double region_distance(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                           const double longest_other_edge, const MPI_Comm &communicator) const;

    /**
     * The first mesh: the simplices of the region that the fluid is asked to fill, but for those that AlphaShape always
     * drops. Collective; @p migration has brought the particles to where they belong, with the region_distance() of an
     * empty mesh. Each rank has its own cells then; Migration::migrate() tells it of the others.
     */
    void create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                     const std::vector<Facet> &solid_facets, const Region &region,
                     const Migration<dim> &migration, FluidMesh<dim> &mesh) const;

    /// The same on one rank.
    void create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                     const std::vector<Facet> &solid_facets, const Region &region, FluidMesh<dim> &mesh) const
    {
      create_mesh(cloud, walls, solid_facets, region, Migration<dim>(), mesh);
    }

    /**
     * Adapt the particles' spacing to the edges of the first mesh, in space, where lattice and walls leave some that are
     * too long or too short. Done before the first step, as often as anything changes, it leaves nothing to do to the
     * remeshing of fluid at rest. Afterwards the first mesh is made anew. Collective, as create_mesh().
     * @return whether anything has changed; if not, @p mesh is the first mesh still.
     */
    bool adapt_first_particles(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const FluidMesh<dim> &mesh,
                               Migration<dim> &migration) const;

    /**
     * Replace @p mesh by a new one of the same particles, some of which are removed or inserted. Collective;
     * @p migration has brought particles and mesh to where they belong, with region_distance(). A cell's fluid follows from
     * its corners and the last mesh, fluid_of_cell().
     *
     * @param walls rigid walls and, as walls that carry particles, the solids' contours.
     * @param solid_facets the contours by particle; their particles stand first in the cloud and remain. In 2D they are
     * edges of the triangulation (constrained Delaunay), so that no triangle crosses a contour; the same holds of the
     * interfaces between fluids.
     */
    Report remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const std::vector<Facet> &solid_facets,
                  const double time_step, FluidMesh<dim> &mesh, Migration<dim> &migration) const;

    /// The same on one rank.
    Report remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const std::vector<Facet> &solid_facets,
                  const double time_step, FluidMesh<dim> &mesh) const
    {
      Migration<dim> nowhere;
      return remesh(cloud, walls, solid_facets, time_step, mesh, nowhere);
    }

  private:
    /// Finds segments, given how long they may be at most (m) and those that there are already.
    using Interfaces = std::function<std::vector<Facet>(const double, const std::vector<Facet> &)>;

    /**
     * The simplices of this rank that may become fluid; all ranks together have every one once.
     *
     * @param interfaces the interfaces as far as they are to be edges of the triangulation.
     * @param n_forced as in Report.
     * @throws RunError if the contours of two solids cross.
     */
    std::vector<Simplex<dim>> own_candidates(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                             const std::vector<Facet> &solid_facets,
                                             const Interfaces &interfaces, const Migration<dim> &migration,
                                             unsigned int &n_forced) const;

    /// ParticleSpacing::adapt(); particles that have been inserted are of the same fluids on all ranks.
    bool adapt_spacing(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const FluidMesh<dim> &mesh,
                       OldDomain<dim> &old_domain, Migration<dim> &migration) const;

    /// What particles hold outside of the mesh more than they did before.
    OutsideVolumes passed_on(const OutsideVolumes &before, const ParticleCloud<dim> &cloud,
                             const FluidMesh<dim> &mesh) const;

    bool keep_volume      = true;
    unsigned int n_fluids = 1;
    FindOutside find_outside; ///< none: nothing is outside
    AlphaShape<dim> alpha_shape;
    ParticleSpacing<dim> particle_spacing;
  };
} // namespace Lahar

#endif
