// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_stop_signal_h
#define lahar_utilities_stop_signal_h

#include <string>

namespace Lahar
{
  /**
   * While an object of this class lives, the signals SIGINT (Ctrl-C) and SIGTERM do not end the program but ask it to
   * stop when it can. The same signal again ends it at once.
   */
  class StopSignal
  {
  public:
    StopSignal();
    ~StopSignal();

    StopSignal(const StopSignal &)            = delete;
    StopSignal &operator=(const StopSignal &) = delete;

    bool received() const;

    /// Name of the signal that came.
    std::string name() const;
  };
} // namespace Lahar

#endif
