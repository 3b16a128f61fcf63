// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_run_output_h
#define lahar_simulator_run_output_h

#include <lahar/postprocess/output_field.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/postprocess/progress.h>
#include <lahar/postprocess/visualization.h>
#include <lahar/simulator/run_parameters.h>
#include <lahar/utilities/appended_file.h>
#include <lahar/utilities/output_directory.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * What a run writes for people: `parameters.prm`, `statistics`, `convergence`, `log` and the snapshots for ParaView, in
   * an output directory that it has for itself. The first rank writes all but the pieces of snapshots.
   *
   * All functions are collective but failure(), release_directory() and those that only tell something. They throw RunError where a
   * file cannot be written.
   */
  template <int dim>
  class RunOutput
  {
  public:
    /// @param parameters are used from begin() or resume() on; they need not be read before.
    RunOutput(const RunParameters &parameters, Parameters &prm, const MPI_Comm &communicator);

    /// Read the entries of the statistics' columns and of the fields for ParaView. @throws InputError
    void parse_parameters();

    /// Take the output directory, see OutputDirectory::take(). @throws InputError
    void take_directory(const OutputDirectory::Use use);

    /// Give it back, before the end.
    void release_directory()
    {
      directory.release();
    }

    /// Prepare the columns of the statistics. @throws InputError if two have the same name, or if one cannot be computed.
    void initialize(const Snapshot<dim> &snapshot);

    /// A warning about the case, which people see before the first step.
    void warn(const std::string &text)
    {
      case_warnings.push_back(text);
    }
    const std::vector<std::string> &warnings() const
    {
      return case_warnings;
    }

    /// Begin the files of a new run, with a first snapshot. @param sizes is a message for people.
    void begin(const Snapshot<dim> &snapshot, const std::string &sizes);

    /// Write a snapshot of the start, walls, parameters and, into `log`, @p sizes, over those of an earlier start.
    /// @throws InputError if the directory has a run.
    void write_start(const Snapshot<dim> &snapshot, const std::string &sizes);

    /// Go on with those of a run that has been loaded, at @p time (s) after @p n_steps steps.
    void resume(const double time, const unsigned int n_steps, const std::string &sizes);

    /// @throws InputError if files are shorter than when the checkpoint was written.
    void check_resumed() const;

    /// When the next snapshot is due, s.
    double next_time() const
    {
      return last_time + parameters.output_interval;
    }

    /// Write the files for ParaView.
    void write_snapshot(const Snapshot<dim> &snapshot);

    /// Write a snapshot if one is due at its time, and begin new means, or if it is the run's last one.
    void write_due_snapshot(const Snapshot<dim> &snapshot);

    /// A step begins, of which means are taken, see TimeMeans.
    void start_step(const double time_step)
    {
      time_means.start_step(time_step);
    }

    /// Append the postprocessors' columns to @p line, which has those of the simulator, and write it; @p convergence_lines
    /// go to that file.
    void write_statistics(TableHandler &line, const Snapshot<dim> &snapshot,
                          const std::string &convergence_lines);

    /// Make again what others have removed of the output, and say so. @throws RunError where that cannot be, as if the
    /// directory has another name now.
    void mend(const Walls<dim> &walls);

    /// See Progress.
    void step(const Progress::Line &line)
    {
      progress->step(line);
    }
    void message(const std::string &text)
    {
      progress->message(text);
    }
    /// The reason goes to the log, if there is one already.
    void failure(const std::string &reason) noexcept;
    void summary(const TimerOutput &timer, const double cell_steps)
    {
      progress->summary(timer, cell_steps);
    }
    double wall_time() const
    {
      return progress->wall_time();
    }

    /// Note down how far the files are, before a checkpoint holds this object.
    void note_sizes();

    /// Wait until all lines are on the disk. First rank.
    void sync() const;

    /// Since the last snapshot that was due.
    TimeMeans &means()
    {
      return time_means;
    }

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time_means &visualization &last_time &statistics_size &convergence_size &earlier_wall_time;
    }

  private:
    void write_parameters() const;

    /// After a snapshot at @p time, or if the interval is another one than before.
    void advance(const double time);

    MPI_Comm communicator;
    const RunParameters &parameters;
    Parameters &prm;
    OutputDirectory directory;
    AppendedFile statistics;
    AppendedFile convergence; ///< the increments of every iteration
    Visualization<dim> visualization;
    std::unique_ptr<Progress> progress; ///< from begin() or resume() on
    std::vector<std::unique_ptr<Postprocessor<dim>>> postprocessors;
    typename OutputField<dim>::List fields;
    TimeMeans time_means;
    std::vector<std::string> case_warnings;
    double last_time               = 0.;                      ///< when a snapshot was due last, s
    double earlier_wall_time       = 0.;                      ///< before the run was resumed, s
    std::uintmax_t statistics_size = 0, convergence_size = 0; ///< of the files at the checkpoint, bytes
  };
} // namespace Lahar

#endif
