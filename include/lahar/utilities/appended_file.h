// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_appended_file_h
#define lahar_utilities_appended_file_h

#include <cstdint>
#include <string>

namespace Lahar
{
  /**
   * A text file that grows by whole lines during a run and is cut back to a known size when the run is resumed.
   *
   * Lines are with the operating system when append() returns, so that a killed program leaves all of them. Nothing
   * is kept in memory. The file stays open: what is removed by others is not lost until it is closed, and mend() can
   * write it again.
   */
  class AppendedFile
  {
  public:
    explicit AppendedFile(const std::string &file_name);
    ~AppendedFile();

    AppendedFile(const AppendedFile &)            = delete;
    AppendedFile &operator=(const AppendedFile &) = delete;

    /// Begin anew with an empty file. @throws RunError
    void begin();

    /// @throws InputError if the file is there and shorter than @p size bytes: what it held is lost.
    void check(const std::uintmax_t size) const;

    /// Cut what lies beyond @p size bytes and go on from there; without a file begin anew. @return whether it was
    /// there. @throws RunError
    bool resume(const std::uintmax_t size);

    /// The same at its end, whole as it is.
    bool go_on();

    /// Append whole lines. @throws RunError, after taking back what was written of them.
    void append(const std::string &lines);

    /// If the file is no longer there under its name, write it again with all lines so far. @return whether that was
    /// necessary. @throws RunError if that fails, or, with @p is_ours, if it holds another number of bytes than it
    /// should; else the file goes on with what others have made of it.
    bool mend(const bool is_ours = true);

    /// Wait until all lines are on the disk. @throws RunError
    void sync() const;

    /// Bytes so far; zero before begin() and resume().
    std::uintmax_t size() const
    {
      return n_bytes;
    }

  private:
    void open(const int flags);
    void close();
    [[noreturn]] void fail(const std::string &reason) const;
    [[noreturn]] void fail() const; ///< with the system's reason

    std::string file_name;
    int descriptor         = -1;
    std::uintmax_t n_bytes = 0;
  };
} // namespace Lahar

#endif
