// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/simulator.h>
#include <lahar/utilities/ranks.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <sstream>

namespace Lahar
{
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
    archive &time &counters &account.volume &account.fluids &account.momentum;
    for (Tensor<1, dim> &force : outlet_forces)
      archive &force;
    archive &*step_control &output;
  }



  template <int dim>
  void Simulator<dim>::write_due_checkpoint()
  {
    const bool was_removed = checkpoint.was_removed();
    if (!checkpoint.is_due(counters.steps, output.wall_time(), was_removed))
      return;
    output.mend(walls); // where the directory has another name now there is no checkpoint to write
    output.message(was_removed ? "Warning: the checkpoint in '" + input.run.output_directory +
                                   "' was removed while the run wrote to it. There is a new one."
                               : "");
    write_checkpoint();
  }



  template <int dim>
  std::string Simulator<dim>::save_piece() const
  {
    // The own cells with their fluids, their corners, the own particles, and values of the own cells.
    std::vector<bool> is_saved(particles.size(), false);
    std::vector<std::uint64_t> cells, keys;
    std::vector<double> values;
    for (unsigned int c = 0; c < fluid_mesh.n_cells(); ++c)
      if (const Simplex<dim> &cell = fluid_mesh.particle_cells()[c]; particles.is_own(cell))
      {
        for (const unsigned int i : cell)
        {
          is_saved[i] = true;
          cells.push_back(particles.number[i]);
        }
        cells.push_back(fluid_mesh.fluid(c));
        if (!multipliers.values().empty())
          CellTable<dim>::append(CellTable<dim>::key(cell, particles), multipliers.values()[c], keys, values);
      }
    std::vector<double> records;
    for (unsigned int i = 0; i < particles.size(); ++i)
      if (is_saved[i] || particles.is_own(i))
        particles.append_record(i, records);
    std::ostringstream data;
    boost::archive::binary_oarchive archive(data, boost::archive::no_header);
    archive << records << cells << keys << values << ill_posed_cells << migration;
    return data.str();
  }



  template <int dim>
  void Simulator<dim>::load_pieces(const RunCheckpoint::Content &content)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator());
    std::vector<double> records;
    std::vector<std::uint64_t> numbers;
    for (const std::string &piece : content.pieces)
    {
      std::istringstream data(piece);
      boost::archive::binary_iarchive archive(data, boost::archive::no_header);
      std::vector<double> values, cell_values;
      std::vector<std::uint64_t> piece_numbers, cell_keys;
      archive >> values >> piece_numbers >> cell_keys >> cell_values >> ill_posed_cells;
      multipliers.table().add_all(cell_keys, cell_values);
      if (content.same_ranks)
        archive >> migration;
      // A rank's piece was read by this one.
      for (std::size_t owner = particles.record_size() - 1; owner < values.size();
           owner += particles.record_size())
        values[owner] = static_cast<unsigned int>(values[owner]) % n_ranks;
      records.insert(records.end(), values.begin(), values.end());
      numbers.insert(numbers.end(), piece_numbers.begin(), piece_numbers.end());
    }
    // All ranks have the solids' particles, as copies if no piece has them.
    for (unsigned int i = 0; i < solids.mesh().n_contour_nodes(); ++i)
    {
      particles.position[i] = solids.state().position[i];
      particles.velocity[i] = solids.state().velocity[i];
      particles.append_record(i, records);
      records.back() = n_ranks;
    }
    particles.reinit(records);
    std::vector<Simplex<dim>> cells;
    std::vector<unsigned int> fluids;
    for (auto number = numbers.begin(); number != numbers.end(); number += dim + 2)
    {
      cells.emplace_back();
      for (unsigned int c = 0; c <= dim; ++c)
        cells.back()[c] = particles.find(number[c]);
      fluids.push_back(number[dim + 1]);
    }
    fluid_mesh.reinit(particles, cells, fluids);
    multipliers.table().sort();
    migrate();
    if (has_multipliers())
      multipliers.follow(fluid_mesh, particles);
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
    output.note_sizes();
    const std::pair<unsigned int, unsigned int> counts = particles_and_cells();
    if (!is_first_rank(communicator()))
      return "";
    std::ostringstream data;
    boost::archive::binary_oarchive archive(data);
    archive << counts;
    save_or_load(archive);
    return data.str();
  }



  template <int dim>
  void Simulator<dim>::keep_state()
  {
    checkpoint.keep(save_state(), save_piece());
  }



  template <int dim>
  void Simulator<dim>::write_kept_state()
  {
    on_first_rank(communicator(), [&] { output.sync(); });
    checkpoint.write(output.wall_time());
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
    const RunCheckpoint::Content content = checkpoint.read();
    std::pair<unsigned int, unsigned int> counts;
    on_all_ranks(communicator(), [&] {
      try
      {
        std::istringstream data(content.state);
        boost::archive::binary_iarchive archive(data);
        archive >> counts;
        save_or_load(archive);
      }
      catch (const boost::archive::archive_exception &error)
      {
        checkpoint.fail(std::string("cannot be read (") + error.what() + ")",
                        "one written by the same program on the same kind of machine");
      }
    });
    if (input.geometry.any_boundary_moves())
      walls = input.geometry.walls_at(time);
    load_pieces(content);
    if (const auto found = particles_and_cells(); found != counts)
      checkpoint.fail("gives " + std::to_string(found.first) + " particles and " +
                        std::to_string(found.second) + " cells",
                      std::to_string(counts.first) + " and " + std::to_string(counts.second) +
                        ", as there were when it was written");
    output.check_resumed();
    if (input.run.end_time < time - 1e-10 * input.run.time_step)
      prm.throw_wrong_value("End time",
                            "a time not before that of the checkpoint, which is " + std::to_string(time));
  }



  template void Simulator<2>::resume();
  template void Simulator<3>::resume();
  template void Simulator<2>::keep_state();
  template void Simulator<3>::keep_state();
  template void Simulator<2>::write_kept_state();
  template void Simulator<3>::write_kept_state();
  template void Simulator<2>::write_due_checkpoint();
  template void Simulator<3>::write_due_checkpoint();
  template void Simulator<2>::write_checkpoint();
  template void Simulator<3>::write_checkpoint();
} // namespace Lahar
