// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_ranks_h
#define lahar_utilities_ranks_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <functional>
#include <string>

namespace Lahar
{
  using namespace dealii;

  bool is_first_rank(const MPI_Comm &communicator);

  /**
   * Do on the first rank alone what may fail there. @throws InputError on all ranks with the first rank's message if the
   * action threw one, RunError if it threw anything else. Collective.
   */
  void on_first_rank(const MPI_Comm &communicator, const std::function<void()> &action);

  /// The same for what all ranks do: the message is that of the lowest rank that threw.
  void on_all_ranks(const MPI_Comm &communicator, const std::function<void()> &action);

  /// The largest of the ranks' values and its place; of equal values that of the lowest rank. Collective.
  template <int dim>
  std::pair<double, Point<dim>> largest_of_all(const double value, const Point<dim> &place,
                                               const MPI_Comm &communicator);

  /**
   * End a program that has failed: if all ranks arrive here within a few seconds the first one prints @p message, and
   * the caller can return @p status. If this rank is alone, others may wait for it: it prints the message and aborts
   * them all with that status.
   */
  void fail_on_all_ranks(const MPI_Comm &communicator, const std::string &message, const int status);
} // namespace Lahar

#endif
