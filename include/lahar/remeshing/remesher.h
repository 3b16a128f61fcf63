#ifndef lahar_remeshing_remesher_h
#define lahar_remeshing_remesher_h

#include <deal.II/base/mpi.h>

#include <lahar/boundary/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/alpha_shape.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/particle_spacing.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * Remeshing (PFEM): adapt the particles' spacing, triangulate them by Delaunay, keep what AlphaShape accepts,
   * take back what that changed of the volume (VolumeCorrection).
   *
   * The ranks share the triangulation and AlphaShape's decisions: each deals with the simplices whose first fluid
   * particle is its own (local_delaunay()), then all have them all. Constrained triangulations are made by every rank
   * (a constraint has effect across any distance); their simplices are shared out in the same way.
   */
  template <int dim>
  class Remesher
  {
  public:
    using Facet = std::array<unsigned int, dim>;

    /// What a remeshing did.
    struct Report
    {
      bool changed          = false; ///< the connectivity
      unsigned int n_forced = 0; ///< facets of solids' contours that the Delaunay triangulation did not have
      std::vector<bool> arrives; ///< by vertex: whether it is a corner of a cell that was no fluid before
    };

    /// Alone by default.
    explicit Remesher(const MPI_Comm &communicator = MPI_COMM_SELF);

    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// The first mesh of a cloud: the simplices of @p wet particles that the plain alpha shape accepts. Collective.
    void create_mesh(const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                     const std::vector<Facet> &solid_facets, const std::vector<bool> &wet,
                     FluidMesh<dim> &mesh) const;

    /**
     * Replace @p mesh by a new one of the same particles, some of which are removed or inserted. Collective; all
     * ranks have the same cloud and the same mesh.
     *
     * @param walls rigid walls and, as no-slip walls, the solids' contours.
     * @param solid_facets the contours by particle; their particles stand first in the cloud and remain. In 2D they are
     * edges of the triangulation (constrained Delaunay), so that no triangle crosses a contour.
     */
    Report remesh(ParticleCloud<dim> &cloud, const Walls<dim> &walls, const std::vector<Facet> &solid_facets,
                  const double time_step, FluidMesh<dim> &mesh) const;

  private:
    /**
     * The simplices of this rank that may become fluid; all ranks together have every one once.
     *
     * @param n_forced as in Report.
     * @throws RunError if the contours of two solids cross.
     */
    std::vector<Simplex<dim>> own_candidates(const ParticleCloud<dim> &cloud,
                                             const std::vector<Facet> &solid_facets,
                                             unsigned int &n_forced) const;

    MPI_Comm communicator;
    bool keep_volume = true;
    AlphaShape<dim> alpha_shape;
    ParticleSpacing<dim> particle_spacing;
  };
} // namespace Lahar

#endif
