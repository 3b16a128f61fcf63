// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/simulator.h>
#include <lahar/utilities/ranks.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <sstream>

namespace Lahar
{
  template <int dim>
  template <typename Archive>
  void Simulator<dim>::save_or_load(Archive &archive)
  {
    archive &region.particles.next_number;
    SolidState<dim> solid_state = solids.state();
    archive &solid_state;
    if constexpr (Archive::is_loading::value)
    {
      if (solid_state.stress.size() != solids.state().stress.size())
        checkpoint.fail("has solids of another mesh", "the mesh files of the run");
      solids.accept(solid_state);
    }
    archive &time;
    account.save_or_load(archive);
    outlets.save_or_load_forces(archive);
    archive &*step_control &output;
  }



  template <int dim>
  void Simulator<dim>::write_due_checkpoint()
  {
    const bool was_removed = checkpoint.was_removed();
    if (!checkpoint.is_due(account.counters.steps, output.wall_time(), was_removed))
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
    std::ostringstream data;
    boost::archive::binary_oarchive archive(data, boost::archive::no_header);
    region.save(archive);
    archive << account.ill_posed_cells << migration;
    return data.str();
  }



  template <int dim>
  void Simulator<dim>::load_pieces(const RunCheckpoint::Content &content)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator());
    typename FluidRegion<dim>::Pieces pieces;
    for (const std::string &piece : content.pieces)
    {
      std::istringstream data(piece);
      boost::archive::binary_iarchive archive(data, boost::archive::no_header);
      region.load(archive, n_ranks, pieces);
      archive >> account.ill_posed_cells;
      if (content.same_ranks)
        archive >> migration;
    }
    region.reinit(std::move(pieces), solids, n_ranks);
    // On as many ranks the next step finds all where it was, and brings it to other ranks as in a run without a break.
    if (content.same_ranks)
      region.tell_owners(solids.mesh().n_contour_nodes(), communicator());
    migrate(content.same_ranks);
    if (has_multipliers())
      region.multipliers.follow(region.mesh, region.particles);
  }



  template <int dim>
  std::string Simulator<dim>::save_state()
  {
    output.note_sizes();
    const std::pair<unsigned int, unsigned int> counts = region.n_particles_and_cells(communicator());
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
    if (const auto found = region.n_particles_and_cells(communicator()); found != counts)
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
