// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_checkpoint_file_h
#define lahar_utilities_checkpoint_file_h

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * A checkpoint in an output directory: the first rank's file `checkpoint/state` and, of a run on several ranks, a
   * piece of each other one, `checkpoint/piece-NUMBER-RANK-of-RANKS`.
   *
   * Each has a text header with the format's version, the run, the number of the checkpoint in it, the rank, and length
   * and CRC-32 checksum of the binary data that follow; the checksum is one of the header, too. The checksums of all
   * pieces are among the data of the state, so that a checkpoint consists of the pieces with which it was written and
   * of no others. Every checkpoint of a run has a number of its own: its pieces are written beside those of the one
   * before, which stay valid until the state has been replaced.
   */
  class CheckpointFile
  {
  public:
    /// Raised whenever the data mean something else.
    static constexpr unsigned int format_version = 12;

    /// Whose data.
    struct Piece
    {
      std::string run; ///< one word
      unsigned int number = 0, rank = 0, n_ranks = 1;
    };

    explicit CheckpointFile(const std::string &output_directory);

    /// A name that no other run has.
    static std::string new_run();

    /// Replace the file of a piece (of rank 0: the state), which is never there in part. @return the checksum. @throws
    /// RunError
    unsigned int write(const Piece &piece, const std::string &data) const;

    /// Read the state. @return its data, and in @p piece whose they are. @throws InputError if the file is missing,
    /// truncated, corrupted or of another format.
    std::string read_state(Piece &piece) const;

    /// Read a piece that has this checksum. @throws InputError as read_state(), or if it is another one.
    std::string read(const Piece &piece, const unsigned int sum) const;

    /// Whether the files of all ranks are there.
    bool exists(const Piece &piece) const;

    /// Remove the pieces of all other checkpoints. @throws RunError
    void remove_pieces_but(const Piece &piece) const;

    /// @throws InputError that names the file, what was @p found and what is @p allowed.
    [[noreturn]] void fail(const std::string &found, const std::string &allowed) const;

  private:
    std::string name_of(const Piece &piece) const;
    std::string read_file(const std::string &name, Piece &piece, unsigned int &sum) const;
    [[noreturn]] void fail(const std::string &name, const std::string &found,
                           const std::string &allowed) const;

    std::string directory;
  };
} // namespace Lahar

#endif
