// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_standard_output_h
#define lahar_utilities_standard_output_h

#include <string>

namespace Lahar
{
  /// Write what the user has asked to see. A reader that has gone away (`lahar --help | head -1`) has seen enough.
  /// @throws RunError with the reason if it cannot be written.
  void write_standard_output(const std::string &text);
} // namespace Lahar

#endif
