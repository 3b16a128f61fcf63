// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/stop_signal.h>

#include <csignal>
#include <utility>

namespace Lahar
{
  namespace
  {
    constexpr std::pair<int, const char *> signal_names[] = {{SIGINT, "SIGINT"},   {SIGTERM, "SIGTERM"},
                                                             {SIGHUP, "SIGHUP"},   {SIGUSR1, "SIGUSR1"},
                                                             {SIGUSR2, "SIGUSR2"}, {SIGXCPU, "SIGXCPU"}};

    // A signal handler can reach nothing else.
    volatile std::sig_atomic_t last_signal = 0;

    void handle(const int signal)
    {
      last_signal = signal;
      if (signal == SIGINT || signal == SIGTERM)
      {
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
      }
    }
  } // namespace



  void StopSignal::catch_all()
  {
    last_signal = 0;
    for (const auto &[signal, name] : signal_names)
      if (std::signal(signal, handle) == SIG_IGN && signal == SIGHUP)
        std::signal(signal, SIG_IGN);
  }



  int StopSignal::received(const MPI_Comm &communicator)
  {
    return dealii::Utilities::MPI::max(static_cast<int>(last_signal), communicator);
  }



  std::string StopSignal::name(const int signal)
  {
    for (const auto &[number, name] : signal_names)
      if (number == signal)
        return name;
    return "";
  }
} // namespace Lahar
