// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_share_of_rank_h
#define lahar_utilities_share_of_rank_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <utility>

namespace Lahar
{
  /// This rank's share of @p n things in a row, from the first to before the second number: as many for each.
  inline std::pair<unsigned int, unsigned int> share_of_rank(const std::uint64_t n,
                                                             const MPI_Comm &communicator)
  {
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(communicator),
                       n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
    return {n * rank / n_ranks, n * (rank + 1) / n_ranks};
  }
} // namespace Lahar

#endif
