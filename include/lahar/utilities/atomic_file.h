// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_atomic_file_h
#define lahar_utilities_atomic_file_h

#include <functional>
#include <ostream>
#include <string>

namespace Lahar
{
  /// What the names of temporary files end with.
  extern const std::string temporary_ending;

  /**
   * Write a file so that it never exists in part: what @p write puts out goes into a temporary file beside it,
   * NAME.HOST-PID.part, which takes its name once it is on the disk. Two processes never share a temporary file.
   * @throws RunError with the file's name and the reason if that fails, and whatever @p write throws; no temporary file is
   * left.
   */
  void write_atomically(const std::string &file_name, const std::function<void(std::ostream &)> &write);
} // namespace Lahar

#endif
