// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_migration_h
#define lahar_remeshing_migration_h

#include <deal.II/base/bounding_box.h>

#include <lahar/particles/particle_cloud.h>
#include <lahar/particles/recursive_bisection.h>
#include <lahar/remeshing/cell_table.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/utilities/halo_exchange.h>

#include <vector>

namespace Lahar
{
  /**
   * Who owns the particles, and what a rank knows of those of others.
   *
   * Space is divided among the ranks so that all have the same work (RecursiveBisection, the work of a particle being
   * one and the number of its cells); a particle belongs to the rank in whose part it is, a cell to that of its first
   * fluid particle. A rank knows all particles in its region, the bounding box of its own particles widened by a
   * distance on all sides, and all cells with a corner there. All ranks know the particles of the solids' contours.
   *
   * All functions are collective but those that only tell. On one rank, which owns all, nothing is sent.
   */
  template <int dim>
  class Migration
  {
  public:
    /// Alone by default.
    explicit Migration(const MPI_Comm &communicator = MPI_COMM_SELF);

    const MPI_Comm &communicator() const
    {
      return mpi_communicator;
    }

    /// A program that has not initialised MPI, as tests may be, is alone.
    bool is_alone() const;

    /**
     * Bring the particles and the mesh's cells to where they belong by their present positions, and find the mesh's
     * boundary faces anew. Space is divided anew when a rank has more than its share of the work.
     *
     * @param distance by which a rank's region is wider than the box around its own particles, m.
     * @param n_shared particles come first in the cloud on all ranks and stay there.
     * @param values of cells that go with them, or none: afterwards this rank has those that the owners of its cells had.
     * @param keeps_owners whether all stay where they are, and only copies come: after a checkpoint, where a step has moved
     *        particles but not brought them to other ranks yet. All of the cloud's owners must be ranks then.
     */
    void migrate(ParticleCloud<dim> &cloud, FluidMesh<dim> &mesh, const double distance,
                 const unsigned int n_shared, CellTable<dim> *values = nullptr,
                 const bool keeps_owners = false);

    /// Keep of a cloud that all ranks have what belongs to this one.
    void distribute(ParticleCloud<dim> &cloud, const double distance, const unsigned int n_shared);

    /// Follow a change of the particles.
    void reinit(const ParticleCloud<dim> &cloud);

    /// Replace the copies of others' particles by their owners'.
    void update(ParticleCloud<dim> &cloud) const;

    /// Replace the values of others' particles by their owners'. @param values by particle, T of doubles.
    template <typename T>
    void update(std::vector<T> &values) const
    {
      if (!is_alone())
        exchange.update(reinterpret_cast<double *>(values.data()), sizeof(T) / sizeof(double));
    }

    /// A cell and what is to be told of it.
    struct MarkedCell
    {
      Simplex<dim> corners;
      bool is_new;        ///< it was no fluid before
      unsigned int fluid; ///< its number
    };

    /// @return of all ranks' @p own cells those that have a corner in this rank's region, and its own ones. A cell is
    /// left out whose corners this rank does not know.
    std::vector<MarkedCell> collect_cells(const ParticleCloud<dim> &cloud,
                                          const std::vector<MarkedCell> &own) const;

    /// The rank to which what is at a place belongs.
    unsigned int rank_at(const Point<dim> &place) const
    {
      return parts.rank_of(place);
    }

    /// The bounding boxes of the ranks' own particles, the region's core; none for a rank without particles.
    const std::vector<std::vector<BoundingBox<dim>>> &boxes() const
    {
      return all_boxes;
    }

    /// The distance of migrate().
    double distance() const
    {
      return region_distance;
    }

    /// How space is divided, which depends on what came before; it belongs to one number of ranks.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &parts;
    }

  private:
    void divide_space(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh);
    void find_boxes(const ParticleCloud<dim> &cloud, const std::vector<unsigned int> &owners);
    bool is_near(const unsigned int rank, const Point<dim> &point) const;
    /// The ranks in whose regions some of the cloud's particles may be.
    std::vector<unsigned int> ranks_around(const ParticleCloud<dim> &cloud) const;

    MPI_Comm mpi_communicator;
    RecursiveBisection<dim> parts;
    std::vector<std::vector<BoundingBox<dim>>> all_boxes;
    double region_distance = 0.;
    HaloExchange exchange;
  };
} // namespace Lahar

#endif
