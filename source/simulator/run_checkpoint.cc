// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/run_checkpoint.h>
#include <lahar/utilities/checksum.h>
#include <lahar/utilities/ranks.h>
#include <lahar/utilities/same_value.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Entries, and subsections of such, that may change when a run is resumed.
    const std::vector<std::string> changeable = {"Output directory",  "End time",
                                                 "Time step",         "Minimum time step",
                                                 "Maximum time step", "Largest movement",
                                                 "Output interval",   "Checkpoint/",
                                                 "Nonlinear solver/", "Linear solver/",
                                                 "Postprocess/Fields"};

    bool may_change(const std::string &path)
    {
      for (const std::string &entry : changeable)
        if (path == entry || (entry.back() == '/' && path.rfind(entry, 0) == 0))
          return true;
      return false;
    }

    /// Checkpoints by wall time take at most 1 % of it.
    constexpr double duration_factor = 100.;
  } // namespace



  RunCheckpoint::RunCheckpoint(const RunParameters &parameters, const Parameters &prm,
                               const MPI_Comm &communicator)
    : communicator(communicator)
    , parameters(parameters)
    , prm(prm)
    , checkpoint(prm.get("Output directory"))
  {}



  void RunCheckpoint::remember_files()
  {
    for (const auto &[path, value] : prm.values())
      if (std::error_code error; prm.is_file(path) && std::filesystem::is_regular_file(value, error))
        files[path] = checksum_of_file(value);
  }



  bool RunCheckpoint::was_removed() const
  {
    return is_first_rank(communicator) && piece.number > 0 && !checkpoint.exists(piece);
  }



  bool RunCheckpoint::is_due(const unsigned int n_steps, const double wall_time, const bool was_removed) const
  {
    const bool by_steps = parameters.steps_between_checkpoints > 0 &&
                          n_steps % parameters.steps_between_checkpoints == 0;
    const bool by_time = parameters.time_between_checkpoints > 0. &&
                         wall_time - last_wall_time >
                           std::max(parameters.time_between_checkpoints, duration_factor * last_duration);
    return Utilities::MPI::broadcast(communicator, by_steps || by_time || was_removed);
  }



  void RunCheckpoint::keep(std::string state, std::string piece_of_rank)
  {
    kept_state = std::move(state);
    kept_piece = std::move(piece_of_rank);
  }



  void RunCheckpoint::write(const double wall_time)
  {
    const auto start = std::chrono::steady_clock::now();
    if (piece.run.empty())
      piece.run = Utilities::MPI::broadcast(communicator, CheckpointFile::new_run());
    ++piece.number;
    piece.rank       = Utilities::MPI::this_mpi_process(communicator);
    piece.n_ranks    = Utilities::MPI::n_mpi_processes(communicator);
    unsigned int sum = 0; // that of the first rank, whose piece is in the state, is not needed
    on_all_ranks(communicator, [&] {
      if (piece.rank > 0)
        sum = checkpoint.write(piece, kept_piece);
    });
    const std::vector<unsigned int> sums = Utilities::MPI::gather(communicator, sum);
    on_first_rank(communicator, [&] {
      if (parameter_values.empty())
        parameter_values = prm.values();
      std::ostringstream all;
      {
        boost::archive::binary_oarchive archive(all);
        archive << sums << parameter_values << files << kept_state << kept_piece;
      }
      checkpoint.write(piece, all.str());
      checkpoint.remove_pieces_but(piece);
    });
    last_duration  = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    last_wall_time = wall_time + last_duration;
  }



  RunCheckpoint::Content RunCheckpoint::read()
  {
    const std::string all      = checkpoint.read_state(piece);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator), n_pieces = piece.n_ranks;
    Content content;
    content.same_ranks = n_pieces == n_ranks;
    resumed            = true;
    on_all_ranks(communicator, [&] {
      try
      {
        std::istringstream data(all);
        std::vector<unsigned int> sums;
        std::string first_piece;
        std::map<std::string, std::string> earlier_values;
        std::map<std::string, unsigned int> earlier_files;
        boost::archive::binary_iarchive(data) >> sums >> earlier_values >> earlier_files >> content.state >>
          first_piece;
        check_unchanged(earlier_values);
        check_files(earlier_files);
        for (unsigned int p = Utilities::MPI::this_mpi_process(communicator); p < n_pieces; p += n_ranks)
          content.pieces.push_back(
            p == 0 ? first_piece : checkpoint.read({piece.run, piece.number, p, n_pieces}, sums.at(p)));
      }
      catch (const boost::archive::archive_exception &error)
      {
        fail(std::string("cannot be read (") + error.what() + ")",
             "one written by the same program on the same kind of machine");
      }
    });
    return content;
  }



  void RunCheckpoint::check_files(const std::map<std::string, unsigned int> &earlier_files) const
  {
    const std::map<std::string, std::string> values = prm.values();
    for (const auto &[path, sum] : files)
    {
      const auto earlier = earlier_files.find(path);
      if (!may_change(path) && earlier != earlier_files.end() && earlier->second != sum)
        throw InputError(
          "Parameter '" + path + "' is '" + values.at(path) +
          "', a file that has changed since the run began. Allowed when a run is resumed: the file as "
          "it was then (CRC-32 " +
          std::to_string(earlier->second) + ", now " + std::to_string(sum) + ").");
    }
  }



  void RunCheckpoint::check_unchanged(const std::map<std::string, std::string> &earlier_values) const
  {
    const std::map<std::string, std::string> values = prm.values();
    // A case may have moved with its mesh files.
    const auto is_same = [&](const std::string &path, const std::string &a, const std::string &b) {
      return prm.is_file(path) ? std::filesystem::path(a).filename() == std::filesystem::path(b).filename()
                               : same_value(a, b);
    };
    for (const auto &[path, value] : values)
    {
      const auto earlier = earlier_values.find(path);
      if (!may_change(path) && (earlier == earlier_values.end() || !is_same(path, earlier->second, value)))
        throw InputError("Parameter '" + path + "' is '" + value + "'. Allowed when a run is resumed: " +
                         (earlier == earlier_values.end()
                            ? "not to be there, as in the checkpoint"
                            : "'" + earlier->second + "' as in the checkpoint") +
                         ".");
    }
    for (const auto &[path, value] : earlier_values)
      if (values.count(path) == 0)
        throw InputError("Parameter '" + path + "' is not there. Allowed when a run is resumed: '" + value +
                         "' as in the checkpoint.");
  }
} // namespace Lahar
