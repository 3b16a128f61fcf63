// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_output_directory_h
#define lahar_utilities_output_directory_h

#include <lahar/utilities/lock_file.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The directory for everything that a run writes. One process at a time has it, by the file `lock` (LockFile), which
   * goes with this object; a directory that take() made and in which nothing was written goes, too.
   */
  class OutputDirectory
  {
  public:
    /// What a run may find in its directory.
    enum class Use
    {
      begin,     ///< no earlier run
      overwrite, ///< an earlier run, whose files clear() removes
      resume     ///< an earlier run, which goes on
    };

    explicit OutputDirectory(const std::string &name);
    ~OutputDirectory();

    OutputDirectory(const OutputDirectory &)            = delete;
    OutputDirectory &operator=(const OutputDirectory &) = delete;

    /// Give the directory back, before the end.
    void release();

    /// Create the directory if need be and take it for this process. @throws InputError if that is not possible, if
    /// another process has it, or if it holds an earlier run that is neither to be overwritten nor resumed.
    void take(const Use use);

    /// A file that stands there and shows that the directory is that of a run; empty if there is none, or at most what
    /// `--write-start` leaves: the entries, a log without steps and the first snapshot.
    std::string file_of_run() const;

    /// Remove the files of earlier runs, and nothing else. @throws RunError
    void clear() const;

    /// Remove temporary files that killed runs have left. @throws RunError
    void remove_temporaries() const;

    /// Make the directory and the lock anew if someone has removed them since take(). @return what was done, for
    /// people. @throws RunError if the directory has another name now, or another process has taken it.
    std::string mend();

  private:
    /// The files that a run has made, or may have; with @p temporary only those in part.
    std::vector<std::filesystem::path> files_of_runs(const bool temporary) const;
    void open();
    [[noreturn]] void refuse(const std::string &allowed) const;

    std::string name;
    LockFile lock;
    int descriptor = -1;                          ///< of the directory, which may be renamed
    std::vector<std::filesystem::path> made_here; ///< directories that were not there, from the outside
  };
} // namespace Lahar

#endif
