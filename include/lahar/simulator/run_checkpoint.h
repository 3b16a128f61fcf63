// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_run_checkpoint_h
#define lahar_simulator_run_checkpoint_h

#include <deal.II/base/mpi.h>

#include <lahar/simulator/run_parameters.h>
#include <lahar/utilities/checkpoint_file.h>

#include <map>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * The checkpoints of a run: when they are due, what of the case they hold beside the simulator's state, and whether a
   * case may go on from one. See CheckpointFile for the files.
   *
   * A state is noted down before each step and written when that is due, so that a step that is interrupted loses
   * nothing. All functions are collective but was_removed(), keep() and those that only tell something.
   */
  class RunCheckpoint
  {
  public:
    RunCheckpoint(const RunParameters &parameters, const Parameters &prm, const MPI_Comm &communicator);

    /// The case is read: remember the files that the parameters name as they are now.
    void remember_files();

    /// The run begins, or goes on, at this wall time (s).
    void begin(const double wall_time)
    {
      last_wall_time = wall_time;
    }

    /// Whether steps or wall time (s) ask for a checkpoint after step @p n_steps, or the last one @p was_removed.
    bool is_due(const unsigned int n_steps, const double wall_time, const bool was_removed) const;

    /// Whether others have removed the files of the last checkpoint of this run. First rank; false elsewhere.
    bool was_removed() const;

    /// Note down what a checkpoint of this moment holds: @p state on the first rank, and each rank's @p piece.
    void keep(std::string state, std::string piece);

    /// Write what was noted down last. @param wall_time before it, s. @throws RunError
    void write(const double wall_time);

    /// What a checkpoint held.
    struct Content
    {
      std::string state;
      std::vector<std::string> pieces; ///< those that this rank is to take over
      bool same_ranks = false;         ///< whether it was written by as many ranks as there are now
    };

    /// Read the checkpoint in the output directory. @throws InputError if there is none that can be read, or if a
    /// parameter, or what a file holds, differs from the checkpoint's where a resumed run cannot honour it.
    Content read();

    /// Whether the run goes on from a checkpoint.
    bool is_resumed() const
    {
      return resumed;
    }

    /// See CheckpointFile::fail().
    [[noreturn]] void fail(const std::string &found, const std::string &allowed) const
    {
      checkpoint.fail(found, allowed);
    }

  private:
    void check_unchanged(const std::map<std::string, std::string> &earlier_values) const;
    void check_files(const std::map<std::string, unsigned int> &earlier_files) const;

    MPI_Comm communicator;
    const RunParameters &parameters;
    const Parameters &prm;
    CheckpointFile checkpoint;
    CheckpointFile::Piece piece;               ///< this rank's of the last checkpoint
    std::map<std::string, unsigned int> files; ///< checksums of the files that entries name, by entry
    std::map<std::string, std::string> parameter_values; ///< on the first rank, once they are needed
    std::string kept_state, kept_piece;
    bool resumed          = false;
    double last_wall_time = 0., last_duration = 0.; ///< of the last one, s
  };
} // namespace Lahar

#endif
