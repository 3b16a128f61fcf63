// SPDX-License-Identifier: GPL-3.0-or-later

// Test what signals do after StopSignal::catch_all(): all of them ask for a stop, and SIGINT or SIGTERM after one of the two
// ends the program; a SIGHUP that was ignored stays so. What ends the program is tried in processes of their own.

#include <lahar/utilities/stop_signal.h>

#include "tests.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

using namespace Tests;

/// The signal that ends a process which does that, or 0 if it does not end by one.
int ending_signal(const std::function<void()> &action)
{
  const pid_t process = fork();
  if (process == 0)
  {
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(process, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto &[signal, name] : std::vector<std::pair<int, std::string>>{{SIGINT, "SIGINT"},
                                                                             {SIGTERM, "SIGTERM"},
                                                                             {SIGHUP, "SIGHUP"},
                                                                             {SIGUSR1, "SIGUSR1"},
                                                                             {SIGUSR2, "SIGUSR2"},
                                                                             {SIGXCPU, "SIGXCPU"}})
  {
    StopSignal::catch_all();
    check(name + ": none before it comes", StopSignal::received(MPI_COMM_WORLD) == 0);
    std::raise(signal);
    check(name + " asks for a stop and is named",
          StopSignal::name(StopSignal::received(MPI_COMM_WORLD)) == name);
  }

  StopSignal::catch_all();
  check("two SIGTERM end the program", ending_signal([] {
                                         std::raise(SIGTERM);
                                         std::raise(SIGTERM);
                                       }) == SIGTERM);
  check("so do SIGTERM and SIGINT", ending_signal([] {
                                      std::raise(SIGTERM);
                                      std::raise(SIGINT);
                                    }) == SIGINT);
  check("the others come in rows", ending_signal([] {
                                     for (const int signal : {SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGTERM})
                                       for (unsigned int n = 0; n < 2 && (n == 0 || signal != SIGTERM); ++n)
                                         std::raise(signal);
                                   }) == 0);
  check("an ignored SIGHUP stays ignored", ending_signal([] {
                                             std::signal(SIGHUP, SIG_IGN);
                                             StopSignal::catch_all();
                                             std::raise(SIGHUP);
                                             if (StopSignal::received(MPI_COMM_SELF) != 0)
                                               std::raise(SIGKILL);
                                           }) == 0);
  return n_failed;
}
