// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_failure_h
#define lahar_utilities_failure_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <string>

namespace Lahar
{
  /// What an exception says to the user.
  struct Failure
  {
    int status; ///< 2 for InputError, else 1
    std::string message;

    /// Of the exception that is handled at the moment, whatever it is: one line, without the frames of libraries.
    static Failure current();
  };

  /**
   * The exit status of @p action: 0, or that of what it throws, which is told once if all ranks throw. What one of
   * several ranks throws alone it tells, and ends all of them (fail_on_all_ranks()).
   *
   * Call it where all objects whose destructors wait for other ranks (a factorisation of MUMPS') outlive @p action.
   */
  int exit_status(const MPI_Comm &communicator, const std::function<void()> &action);

  /// Set memory aside that is given back when there is no more, so that the message finds some.
  void reserve_memory_for_failure();
} // namespace Lahar

#endif
