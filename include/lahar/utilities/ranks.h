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

  /// Whether all ranks call this within a few seconds. If they do not, others may wait for this one somewhere else.
  bool all_ranks_arrive(const MPI_Comm &communicator);
} // namespace Lahar

#endif
