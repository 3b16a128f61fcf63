// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_appended_file_h
#define lahar_utilities_appended_file_h

#include <cstdint>
#include <fstream>
#include <string>

namespace Lahar
{
  /**
   * A text file that grows by whole lines during a run and is cut back to a known size when the run is resumed.
   *
   * Lines are with the operating system when append() returns, so that a killed program leaves all of them. Nothing
   * is kept in memory.
   */
  class AppendedFile
  {
  public:
    explicit AppendedFile(const std::string &file_name);

    /// Begin anew with an empty file. @throws RunError
    void begin();

    /// @throws InputError if the file is there and shorter than @p size bytes: what it held is lost.
    void check(const std::uintmax_t size) const;

    /// Cut what lies beyond @p size bytes and go on from there; without a file begin anew. @return whether it was
    /// there. @throws RunError
    bool resume(const std::uintmax_t size);

    /// Append whole lines. @throws RunError, after taking back what was written of them.
    void append(const std::string &lines);

    /// Bytes so far; zero before begin() and resume().
    std::uintmax_t size() const
    {
      return n_bytes;
    }

  private:
    [[noreturn]] void fail(const std::string &reason) const;

    std::string file_name;
    std::ofstream file;
    std::uintmax_t n_bytes = 0;
  };
} // namespace Lahar

#endif
