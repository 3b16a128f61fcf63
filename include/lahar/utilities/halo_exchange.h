// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_halo_exchange_h
#define lahar_utilities_halo_exchange_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Sends the values of things that this rank owns to the ranks that have copies of them, and receives those of its own
   * copies.
   *
   * Each rank numbers what it knows as it likes. Messages go only between ranks that have something to tell each other.
   */
  class HaloExchange
  {
  public:
    explicit HaloExchange(const MPI_Comm &communicator);

    /**
     * @param copies local numbers of the things of which this rank has copies.
     * @param owners of these, in the same order.
     * @param keys by which their owners know them.
     * @param find tells the local number of what this rank owns by its key. Collective.
     */
    void reinit(const std::vector<unsigned int> &copies, const std::vector<unsigned int> &owners,
                const std::vector<std::uint64_t> &keys,
                const std::function<unsigned int(const std::uint64_t)> &find);

    /**
     * Replace the values of all copies by their owners'. @param values by local number, @p n_components each.
     * Collective.
     */
    void update(double *values, const unsigned int n_components) const;

  private:
    struct Neighbour
    {
      unsigned int rank;
      std::vector<unsigned int> sent;     ///< own things by local number
      std::vector<unsigned int> received; ///< copies by local number
    };

    MPI_Comm communicator;
    std::vector<Neighbour> neighbours;
  };
} // namespace Lahar

#endif
