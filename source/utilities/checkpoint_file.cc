// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/checkpoint_file.h>
#include <lahar/utilities/checksum.h>
#include <lahar/utilities/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <random>
#include <sstream>

namespace Lahar
{
  namespace
  {
    const std::string title = "Lahar checkpoint", piece_start = "piece-";
  } // namespace



  CheckpointFile::CheckpointFile(const std::string &output_directory)
    : directory(output_directory + "/checkpoint")
  {}



  std::string CheckpointFile::new_run()
  {
    std::random_device random;
    std::ostringstream name;
    name << std::hex << std::setfill('0');
    for (unsigned int i = 0; i < 4; ++i)
      name << std::setw(8) << random();
    return name.str();
  }



  std::string CheckpointFile::name_of(const Piece &piece) const
  {
    return directory + "/" +
           (piece.rank == 0 ? "state"
                            : piece_start + std::to_string(piece.number) + '-' + std::to_string(piece.rank) +
                                "-of-" + std::to_string(piece.n_ranks));
  }



  unsigned int CheckpointFile::write(const Piece &piece, const std::string &data) const
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
      throw RunError("Cannot create '" + directory + "': " + error.message() + ".");
    std::ostringstream header;
    header << title << "\nversion " << format_version << "\nrun " << piece.run << "\nnumber " << piece.number
           << "\nrank " << piece.rank << " of " << piece.n_ranks << "\nbytes " << data.size() << '\n';
    const unsigned int sum = checksum(header.str() + data);
    write_atomically(name_of(piece), [&](std::ostream &file) {
      file << header.str() << "checksum " << sum << '\n' << data;
    });
    return sum;
  }



  std::string CheckpointFile::read_state(Piece &piece) const
  {
    piece.rank = 0;
    unsigned int sum;
    std::string data = read_file(name_of(piece), piece, sum);
    if (piece.rank != 0)
      fail("is the piece of rank " + std::to_string(piece.rank), "that of rank 0");
    return data;
  }



  std::string CheckpointFile::read(const Piece &piece, const unsigned int sum) const
  {
    const std::string name = name_of(piece);
    Piece found;
    unsigned int found_sum;
    std::string data = read_file(name, found, found_sum);
    if (found.run != piece.run)
      fail(name, "is of another run (" + found.run + ")", "that of the run of 'state', " + piece.run);
    if (found.number != piece.number)
      fail(name, "is of checkpoint " + std::to_string(found.number) + " of the run",
           "checkpoint " + std::to_string(piece.number) + ", as 'state' is");
    if (found.rank != piece.rank || found.n_ranks != piece.n_ranks)
      fail(name,
           "is the piece of rank " + std::to_string(found.rank) + " of " + std::to_string(found.n_ranks),
           "that of rank " + std::to_string(piece.rank) + " of " + std::to_string(piece.n_ranks));
    if (found_sum != sum)
      fail(name, "is not the piece with which 'state' was written: its checksum is another one",
           "pieces and 'state' of one checkpoint");
    return data;
  }



  std::string CheckpointFile::read_file(const std::string &name, Piece &piece, unsigned int &sum) const
  {
    std::ifstream file(name, std::ios::binary);
    if (!file || !std::filesystem::is_regular_file(name))
      fail(name, "is not there or cannot be read",
           "an output directory in which a run has left a checkpoint");
    std::string line, word[7];
    unsigned int version = 0;
    std::size_t size     = 0;
    if (!std::getline(file, line) || line != title || !(file >> word[0] >> version) || word[0] != "version")
      fail(name, "is no checkpoint of Lahar", "a file that a run has written");
    if (version != format_version)
      fail(name, "has the format version " + std::to_string(version),
           "version " + std::to_string(format_version) + "; use the version of lahar that wrote it");
    file.get();
    if (!(file >> word[1] >> piece.run >> word[2] >> piece.number >> word[3] >> piece.rank >> word[4] >>
          piece.n_ranks >> word[5] >> size) ||
        word[1] != "run" || word[2] != "number" || word[3] != "rank" || word[4] != "of" || word[5] != "bytes")
      fail(name, "is truncated or corrupted in its header", "a complete file");
    file.get();
    const std::streamoff end_of_header = file.tellg();
    if (!(file >> word[6] >> sum) || word[6] != "checksum")
      fail(name, "is truncated or corrupted in its header", "a complete file");
    file.get();
    const std::string data(std::istreambuf_iterator<char>(file), {});
    if (data.size() != size)
      fail(name, "holds " + std::to_string(data.size()) + " bytes of data", std::to_string(size) + " bytes");
    std::string header(end_of_header, ' ');
    file.clear();
    file.seekg(0);
    file.read(header.data(), header.size());
    if (checksum(header + data) != sum)
      fail(name, "is corrupted: its checksum is wrong", "a file as it was written");
    return data;
  }



  bool CheckpointFile::exists(const Piece &piece) const
  {
    std::error_code error;
    bool all = true;
    for (unsigned int r = 0; r < piece.n_ranks && all; ++r)
      all = std::filesystem::exists(name_of({piece.run, piece.number, r, piece.n_ranks}), error);
    return all;
  }



  void CheckpointFile::remove_pieces_but(const Piece &kept) const
  {
    std::error_code error;
    for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
         entry.increment(error))
    {
      const std::string name = entry->path().filename().string();
      bool is_kept           = name.rfind(piece_start, 0) != 0;
      for (unsigned int r = 1; r < kept.n_ranks && !is_kept; ++r)
        is_kept = directory + "/" + name == name_of({kept.run, kept.number, r, kept.n_ranks});
      if (!is_kept)
        std::filesystem::remove(entry->path(), error);
    }
    if (error)
      throw RunError("Cannot remove pieces of checkpoints in '" + directory + "': " + error.message() + ".");
  }



  void CheckpointFile::fail(const std::string &found, const std::string &allowed) const
  {
    fail(name_of({}), found, allowed);
  }



  void CheckpointFile::fail(const std::string &name, const std::string &found,
                            const std::string &allowed) const
  {
    throw InputError("Option --resume: the checkpoint '" + name + "' " + found + ". Allowed: " + allowed +
                     ".");
  }
} // namespace Lahar
