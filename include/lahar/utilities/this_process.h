// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_this_process_h
#define lahar_utilities_this_process_h

#include <string>

namespace Lahar
{
  /// The name of the machine that this process runs on.
  std::string host_name();

  /// HOST-PID, which no other process has that writes to the same files.
  std::string process_name();
} // namespace Lahar

#endif
