// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/simulator.h>
#include <lahar/utilities/checksum.h>
#include <lahar/utilities/ranks.h>
#include <lahar/utilities/same_value.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
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
                                                 "Nonlinear solver/", "Linear solver/"};

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



  template <int dim>
  template <typename Archive>
  void Simulator<dim>::save_or_load(Archive &archive)
  {
    archive &particles.next_number;
    SolidState<dim> solid_state = solids.state();
    archive &solid_state;
    if constexpr (Archive::is_loading::value)
    {
      if (solid_state.stress.size() != solids.state().stress.size())
        checkpoint.fail("has solids of another mesh", "the mesh files of the run");
      solids.accept(solid_state);
    }
    archive &time &step_number &n_rejected &n_forced_facets &n_kept_out &n_left;
    archive &initial_volume &volume &change_by_solver &change_by_remeshing &left_volume;
    archive &momentum &means;
    archive &*step_control &*visualization;
    archive &last_output_time &statistics_size &convergence_size &earlier_wall_time;
  }



  template <int dim>
  bool Simulator<dim>::checkpoint_is_due() const
  {
    const bool by_steps = parameters.steps_between_checkpoints > 0 &&
                          step_number % parameters.steps_between_checkpoints == 0;
    const bool by_time = parameters.time_between_checkpoints > 0. &&
                         progress->wall_time() - last_checkpoint_wall_time >
                           std::max(parameters.time_between_checkpoints,
                                    duration_factor * checkpoint_duration);
    const bool is_removed = is_first_rank(communicator) && piece.number > 0 && !checkpoint.exists(piece);
    progress->message(is_removed ? "Warning: the checkpoint in '" + parameters.output_directory +
                                     "' was removed while the run wrote to it. There is a new one."
                                 : "");
    return Utilities::MPI::broadcast(communicator, by_steps || by_time || is_removed);
  }



  template <int dim>
  std::string Simulator<dim>::save_piece() const
  {
    // The own cells, their corners, and the own particles.
    std::vector<bool> is_saved(particles.size(), false);
    std::vector<std::uint64_t> cells;
    for (const Simplex<dim> &cell : fluid_mesh.particle_cells())
      if (particles.is_own(cell))
        for (const unsigned int i : cell)
        {
          is_saved[i] = true;
          cells.push_back(particles.number[i]);
        }
    std::vector<double> records;
    for (unsigned int i = 0; i < particles.size(); ++i)
      if (is_saved[i] || particles.is_own(i))
      {
        const auto record = particles.record(i);
        records.insert(records.end(), record.begin(), record.end());
      }
    std::ostringstream data;
    boost::archive::binary_oarchive archive(data, boost::archive::no_header);
    archive << records << cells << migration;
    return data.str();
  }



  template <int dim>
  void Simulator<dim>::load_pieces(const std::vector<std::string> &pieces, const bool divide)
  {
    using Record               = typename ParticleCloud<dim>::Record;
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::vector<Record> records;
    std::vector<std::uint64_t> numbers;
    for (const std::string &piece : pieces)
    {
      std::istringstream data(piece);
      boost::archive::binary_iarchive archive(data, boost::archive::no_header);
      std::vector<double> values;
      std::vector<std::uint64_t> piece_numbers;
      archive >> values >> piece_numbers;
      if (divide)
        archive >> migration;
      for (auto value = values.begin(); value != values.end(); value += Record().size())
      {
        records.emplace_back();
        std::copy_n(value, records.back().size(), records.back().begin());
        // A rank's piece was read by this one.
        records.back().back() = static_cast<unsigned int>(records.back().back()) % n_ranks;
      }
      numbers.insert(numbers.end(), piece_numbers.begin(), piece_numbers.end());
    }
    // All ranks have the solids' particles, as copies if no piece has them.
    for (unsigned int i = 0; i < solids.mesh().n_contour_nodes(); ++i)
    {
      particles.position[i] = solids.state().position[i];
      particles.velocity[i] = solids.state().velocity[i];
      records.push_back(particles.record(i));
      records.back().back() = n_ranks;
    }
    particles.reinit(std::move(records));
    std::vector<Simplex<dim>> cells(numbers.size() / (dim + 1));
    for (unsigned int k = 0; k < numbers.size(); ++k)
      cells[k / (dim + 1)][k % (dim + 1)] = particles.find(numbers[k]);
    fluid_mesh.reinit(particles, cells);
    migrate();
  }



  template <int dim>
  std::pair<unsigned int, unsigned int> Simulator<dim>::particles_and_cells() const
  {
    unsigned int n_own = 0;
    for (unsigned int i = 0; i < particles.size(); ++i)
      n_own += particles.is_own(i);
    return {count_on_ranks(n_own), count_on_ranks(fluid_mesh.own_cells(particles).size())};
  }



  template <int dim>
  std::string Simulator<dim>::save_state()
  {
    earlier_wall_time                                  = progress->wall_time();
    const std::pair<unsigned int, unsigned int> counts = particles_and_cells();
    if (!is_first_rank(communicator))
      return "";
    if (parameter_values.empty())
      parameter_values = prm.values();
    statistics_size  = statistics.size();
    convergence_size = convergence.size();
    std::ostringstream data;
    {
      boost::archive::binary_oarchive archive(data);
      archive << parameter_values << files << counts;
      save_or_load(archive);
    }
    return data.str();
  }



  template <int dim>
  void Simulator<dim>::keep_state()
  {
    kept.piece = save_piece();
    kept.state = save_state();
  }



  template <int dim>
  void Simulator<dim>::write_kept_state()
  {
    const double start = progress->wall_time();
    if (piece.run.empty())
      piece.run = Utilities::MPI::broadcast(communicator, CheckpointFile::new_run());
    ++piece.number;
    piece.rank       = Utilities::MPI::this_mpi_process(communicator);
    piece.n_ranks    = Utilities::MPI::n_mpi_processes(communicator);
    unsigned int sum = 0; // that of the first rank, whose piece is in the state, is not needed
    on_all_ranks(communicator, [&] {
      if (piece.rank > 0)
        sum = checkpoint.write(piece, kept.piece);
    });
    const std::vector<unsigned int> sums = Utilities::MPI::gather(communicator, sum);
    on_first_rank(communicator, [&] {
      statistics.sync();
      convergence.sync();
      std::ostringstream all;
      {
        boost::archive::binary_oarchive archive(all);
        archive << sums << kept.state << kept.piece;
      }
      checkpoint.write(piece, all.str());
      checkpoint.remove_pieces_but(piece);
    });
    last_checkpoint_wall_time = progress->wall_time();
    checkpoint_duration       = last_checkpoint_wall_time - start;
  }



  template <int dim>
  void Simulator<dim>::write_checkpoint()
  {
    keep_state();
    write_kept_state();
  }



  template <int dim>
  void Simulator<dim>::resume()
  {
    const std::string all = checkpoint.read_state(piece);
    visualization         = std::make_unique<Visualization<dim>>(parameters.output_directory, communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator), n_pieces = piece.n_ranks;
    std::vector<std::string> pieces;
    std::pair<unsigned int, unsigned int> counts;
    on_all_ranks(communicator, [&] {
      try
      {
        std::istringstream data(all);
        std::vector<unsigned int> sums;
        std::string state, first_piece;
        boost::archive::binary_iarchive(data) >> sums >> state >> first_piece;
        data.str(state);
        boost::archive::binary_iarchive archive(data);
        std::map<std::string, std::string> earlier_values;
        std::map<std::string, unsigned int> earlier_files;
        archive >> earlier_values >> earlier_files >> counts;
        check_unchanged(earlier_values);
        check_files(earlier_files);
        save_or_load(archive);
        for (unsigned int p = Utilities::MPI::this_mpi_process(communicator); p < n_pieces; p += n_ranks)
          pieces.push_back(p == 0 ? first_piece
                                  : checkpoint.read({piece.run, piece.number, p, n_pieces}, sums.at(p)));
      }
      catch (const boost::archive::archive_exception &error)
      {
        checkpoint.fail(std::string("cannot be read (") + error.what() + ")",
                        "one written by the same program on the same kind of machine");
      }
    });
    load_pieces(pieces, n_pieces == n_ranks);
    if (const auto found = particles_and_cells(); found != counts)
      checkpoint.fail("gives " + std::to_string(found.first) + " particles and " +
                        std::to_string(found.second) + " cells",
                      std::to_string(counts.first) + " and " + std::to_string(counts.second) +
                        ", as there were when it was written");
    statistics.check(statistics_size);
    convergence.check(convergence_size);
    resumed = true;
    if (parameters.end_time < time - 1e-10 * parameters.time_step)
      prm.throw_wrong_value("End time",
                            "a time not before that of the checkpoint, which is " + std::to_string(time));
  }



  template <int dim>
  std::map<std::string, unsigned int> Simulator<dim>::file_checksums() const
  {
    std::map<std::string, unsigned int> result;
    for (const auto &[path, value] : prm.values())
      if (std::error_code error; prm.is_file(path) && std::filesystem::is_regular_file(value, error))
        result[path] = checksum_of_file(value);
    return result;
  }



  template <int dim>
  void Simulator<dim>::check_files(const std::map<std::string, unsigned int> &earlier_files) const
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



  template <int dim>
  void Simulator<dim>::check_unchanged(const std::map<std::string, std::string> &earlier_values) const
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



  template std::map<std::string, unsigned int> Simulator<2>::file_checksums() const;
  template std::map<std::string, unsigned int> Simulator<3>::file_checksums() const;
  template void Simulator<2>::resume();
  template void Simulator<3>::resume();
  template bool Simulator<2>::checkpoint_is_due() const;
  template bool Simulator<3>::checkpoint_is_due() const;
  template void Simulator<2>::keep_state();
  template void Simulator<3>::keep_state();
  template void Simulator<2>::write_kept_state();
  template void Simulator<3>::write_kept_state();
  template void Simulator<2>::write_checkpoint();
  template void Simulator<3>::write_checkpoint();
} // namespace Lahar
