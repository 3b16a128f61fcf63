#ifndef lahar_utilities_halo_exchange_h
#define lahar_utilities_halo_exchange_h

#include <deal.II/base/mpi.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Sends the values of things that this rank owns to the ranks that have copies of them, and receives those of its own
   * copies.
   *
   * Each rank numbers what it knows as it likes; what it owns comes first. Messages go only between ranks that have
   * something to tell each other.
   */
  class HaloExchange
  {
  public:
    explicit HaloExchange(const MPI_Comm &communicator);

    /**
     * @param n_own how many things this rank owns.
     * @param owners of the copies, in their local order.
     * @param numbers of the copies with their owners. Collective.
     */
    void reinit(const unsigned int n_own, const std::vector<unsigned int> &owners,
                const std::vector<unsigned int> &numbers);

    /**
     * Replace the values of all copies by their owners'. @param values by local number, @p n_components each, those of
     * the copies after the own ones. Collective.
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
