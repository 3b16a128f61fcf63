// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_lock_file_h
#define lahar_utilities_lock_file_h

#include <string>

namespace Lahar
{
  /**
   * A file that one process at a time holds, with the names of its host and of the process in it.
   *
   * It is locked by flock(2), which the system takes back however the process ends, so that no number of a process
   * needs to be trusted that another one may have by now. Over NFS this reaches other hosts, but not with every server;
   * therefore a file that names another host counts as held even where the lock can be had. Where there are no locks at
   * all, it counts as held by its process as long as one with this number runs. The file is removed when it is
   * released; what a killed process leaves of it is taken over on its host.
   */
  class LockFile
  {
  public:
    LockFile() = default;
    ~LockFile();

    LockFile(const LockFile &)            = delete;
    LockFile &operator=(const LockFile &) = delete;

    /// Take the lock. @return nothing, or who holds it, as a sentence's beginning, and what to do. @throws RunError if
    /// the file cannot be made.
    std::string acquire(const std::string &name);

    void release();

    /// Whether the file is there and the one that this process holds.
    bool is_kept() const;

  private:
    int descriptor = -1;
    std::string file_name;
  };
} // namespace Lahar

#endif
