// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_stop_signal_h
#define lahar_utilities_stop_signal_h

#include <deal.II/base/mpi.h>

#include <exception>
#include <string>

namespace Lahar
{
  /// Leaves a time step that a signal has interrupted; no failure.
  class StopRequest : public std::exception
  {};

  /**
   * After catch_all() these signals do not end the program but ask it to stop when it can: SIGINT (Ctrl-C), SIGTERM,
   * SIGHUP (the connection is lost), SIGUSR1, SIGUSR2 and SIGXCPU (batch systems before they end a job). A second SIGINT
   * or SIGTERM ends it at once; the others, which come in rows, only ask. A SIGHUP that is ignored (nohup) stays so. What
   * comes when the run has ended already does not spoil its exit status.
   */
  class StopSignal
  {
  public:
    static void catch_all();

    /// The signal that any of the ranks has received, or 0; the same on all ranks. Collective.
    static int received(const MPI_Comm &communicator);

    /// As in "SIGTERM".
    static std::string name(const int signal);
  };
} // namespace Lahar

#endif
