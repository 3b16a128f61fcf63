// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_checkpoint_file_h
#define lahar_utilities_checkpoint_file_h

#include <string>

namespace Lahar
{
  /**
   * The file `checkpoint/state` in an output directory: a text header with the format's version and the length and
   * CRC-32 checksum of the binary data that follow. Of a run on several ranks, whose first one writes that file, the
   * others have files of the same kind beside it, `checkpoint/piece-STEP-RANK-of-RANKS`.
   */
  class CheckpointFile
  {
  public:
    /// Raised whenever the data mean something else.
    static constexpr unsigned int format_version = 4;

    explicit CheckpointFile(const std::string &output_directory);

    /// Replace the file, which is never there in part. @throws RunError
    void write(const std::string &data) const;

    /// @return the data. @throws InputError if the file is missing, truncated, corrupted or of another format.
    std::string read() const;

    /// Which piece of which checkpoint.
    struct Piece
    {
      unsigned int step, rank, n_ranks;
    };

    void write(const Piece &piece, const std::string &data) const;
    std::string read(const Piece &piece) const;

    /// Remove all pieces but those of the same step and number of ranks. @throws RunError
    void remove_pieces_but(const Piece &piece) const;

    /// Remove the file, and its pieces, if there is one. @throws RunError
    void remove() const;

    /// @throws InputError that names the file, what was @p found and what is @p allowed.
    [[noreturn]] void fail(const std::string &found, const std::string &allowed) const;

  private:
    void write_file(const std::string &name, const std::string &data) const;
    std::string read_file(const std::string &name) const;
    [[noreturn]] void fail(const std::string &name, const std::string &found,
                           const std::string &allowed) const;

    std::string directory, file_name;
  };
} // namespace Lahar

#endif
