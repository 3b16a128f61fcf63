// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_fluid_region_h
#define lahar_simulator_fluid_region_h

#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/plastic_multipliers.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/solid/solids.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace boost
{
  namespace archive
  {
    class binary_iarchive;
    class binary_oarchive;
  } // namespace archive
} // namespace boost

namespace Lahar
{
  /**
   * What is in a rank's region between two steps: the particles, those of walls and solids' contours among them, the
   * fluid's mesh, whose vertices are particles, and what its cells carry from step to step.
   *
   * A checkpoint has a piece of each rank: its own cells with their fluids and multipliers, and their corners and the own
   * particles as records. All ranks' pieces together are the fluid, whatever number of ranks goes on from them.
   */
  template <int dim>
  struct FluidRegion
  {
    ParticleCloud<dim> particles;
    FluidMesh<dim> mesh;
    typename Remesher<dim>::Report remeshing; ///< which made the mesh
    PlasticMultipliers<dim> multipliers;      ///< where a yield stress is exact

    /// Own particles and cells, on all ranks. Collective.
    std::pair<unsigned int, unsigned int> n_particles_and_cells(const MPI_Comm &communicator) const;

    /// Write this rank's piece.
    void save(boost::archive::binary_oarchive &archive) const;

    /// Some pieces of a checkpoint.
    struct Pieces
    {
      std::vector<double> records;
      std::vector<std::uint64_t> cells; ///< the corners' numbers and the fluid of each
    };

    /// Read another piece, written by any of the ranks; what its cells carry is taken over at once.
    void load(boost::archive::binary_iarchive &archive, const unsigned int n_ranks, Pieces &pieces);

    /// Take over what was read: particles and mesh are those of @p pieces and the contours of @p solids, which all of
    /// @p n_ranks ranks have, as copies if no piece has them. Migration::migrate() brings them to where they belong.
    void reinit(Pieces pieces, const Solids<dim> &solids, const unsigned int n_ranks);

    /// Tell all ranks who owns each of the first @p n particles, the contours', which the owner knows. Collective.
    void tell_owners(const unsigned int n, const MPI_Comm &communicator);
  };
} // namespace Lahar

#endif
