// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_true_on_all_ranks_h
#define lahar_utilities_true_on_all_ranks_h

#include <deal.II/base/mpi.h>

namespace Lahar
{
  /// Whether something is so on all ranks. Collective.
  inline bool true_on_all_ranks(const bool value, const MPI_Comm &communicator)
  {
    return dealii::Utilities::MPI::min(value ? 1U : 0U, communicator) == 1U;
  }
} // namespace Lahar

#endif
