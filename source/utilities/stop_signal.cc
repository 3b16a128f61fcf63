// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/stop_signal.h>

#include <csignal>

namespace Lahar
{
  namespace
  {
    // A signal handler can reach nothing else.
    volatile std::sig_atomic_t last_signal = 0;

    void handle(const int signal)
    {
      last_signal = signal;
      std::signal(signal, SIG_DFL);
    }
  } // namespace



  StopSignal::StopSignal()
  {
    last_signal = 0;
    std::signal(SIGINT, handle);
    std::signal(SIGTERM, handle);
  }



  StopSignal::~StopSignal()
  {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }



  bool StopSignal::received() const
  {
    return last_signal != 0;
  }



  std::string StopSignal::name() const
  {
    return last_signal == SIGINT ? "SIGINT" : "SIGTERM";
  }
} // namespace Lahar
