// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/checkpoint_file.h>
#include <lahar/utilities/exceptions.h>

#include <boost/crc.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace Lahar
{
  namespace
  {
    const std::string title = "Lahar checkpoint";

    unsigned int checksum(const std::string &data)
    {
      boost::crc_32_type crc;
      crc.process_bytes(data.data(), data.size());
      return crc.checksum();
    }
  } // namespace



  CheckpointFile::CheckpointFile(const std::string &output_directory)
    : directory(output_directory + "/checkpoint")
    , file_name(directory + "/state")
  {}



  void CheckpointFile::write(const std::string &data) const
  {
    write_file(file_name, data);
  }



  std::string CheckpointFile::read() const
  {
    return read_file(file_name);
  }



  namespace
  {
    const std::string piece_start = "piece-";

    std::string name_of(const CheckpointFile::Piece &piece)
    {
      return piece_start + std::to_string(piece.step) + '-' + std::to_string(piece.rank) + "-of-" +
             std::to_string(piece.n_ranks);
    }
  } // namespace



  void CheckpointFile::write(const Piece &piece, const std::string &data) const
  {
    write_file(directory + "/" + name_of(piece), data);
  }



  std::string CheckpointFile::read(const Piece &piece) const
  {
    return read_file(directory + "/" + name_of(piece));
  }



  void CheckpointFile::write_file(const std::string &name, const std::string &data) const
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
      throw RunError("Cannot create '" + directory + "': " + error.message() + ".");
    write_atomically(name, [&](std::ostream &file) {
      file << title << "\nversion " << format_version << "\nbytes " << data.size() << "\nchecksum "
           << checksum(data) << '\n'
           << data;
    });
  }



  std::string CheckpointFile::read_file(const std::string &name) const
  {
    std::ifstream file(name, std::ios::binary);
    if (!file || !std::filesystem::is_regular_file(name))
      fail(name, "is not there or cannot be read",
           "an output directory in which a run has left a checkpoint");
    std::string line, word[3];
    unsigned int version = 0, sum = 0;
    std::size_t size = 0;
    if (!std::getline(file, line) || line != title || !(file >> word[0] >> version) || word[0] != "version")
      fail(name, "is no checkpoint of Lahar", "a file that a run has written");
    if (version != format_version)
      fail(name, "has the format version " + std::to_string(version),
           "version " + std::to_string(format_version) + "; use the version of lahar that wrote it");
    if (!(file >> word[1] >> size >> word[2] >> sum) || word[1] != "bytes" || word[2] != "checksum")
      fail(name, "is truncated or corrupted in its header", "a complete file");
    file.get();
    const std::string data(std::istreambuf_iterator<char>(file), {});
    if (data.size() != size)
      fail(name, "holds " + std::to_string(data.size()) + " bytes of data", std::to_string(size) + " bytes");
    if (checksum(data) != sum)
      fail(name, "is corrupted: its checksum is wrong", "a file as it was written");
    return data;
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
        is_kept = name == name_of({kept.step, r, kept.n_ranks});
      if (!is_kept)
        std::filesystem::remove(entry->path(), error);
    }
    if (error)
      throw RunError("Cannot remove pieces of checkpoints in '" + directory + "': " + error.message() + ".");
  }



  void CheckpointFile::remove() const
  {
    std::error_code error;
    std::filesystem::remove(file_name, error);
    if (error)
      throw RunError("Cannot remove '" + file_name + "': " + error.message() + ".");
    if (std::filesystem::is_directory(directory, error))
      remove_pieces_but({0, 0, 1});
  }



  void CheckpointFile::fail(const std::string &found, const std::string &allowed) const
  {
    fail(file_name, found, allowed);
  }



  void CheckpointFile::fail(const std::string &name, const std::string &found,
                            const std::string &allowed) const
  {
    throw InputError("Option --resume: the checkpoint '" + name + "' " + found + ". Allowed: " + allowed +
                     ".");
  }
} // namespace Lahar
