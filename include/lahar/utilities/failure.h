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
   * The exit status of @p action: 0, or that of what it throws, which the first rank prints if all ranks throw. A rank
   * that throws alone prints it, appends it to the log (set_failure_log()) and aborts all ranks with that status, since
   * others may wait for it.
   *
   * Call it where all objects whose destructors wait for other ranks (a factorisation of MUMPS') outlive @p action.
   */
  int exit_status(const MPI_Comm &communicator, const std::function<void()> &action);

  /// The file, which exists, for log_failure(); no name: none.
  void set_failure_log(const std::string &file_name);

  /// Append the reason for which the run fails to that file, if that is possible. Handlers of signals may call it.
  void log_failure(const char *reason) noexcept;

  /// Set memory aside that is given back when there is no more, so that the message finds some.
  void reserve_memory_for_failure();
} // namespace Lahar

#endif
