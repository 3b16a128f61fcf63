// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/statistics_line.h>
#include <lahar/postprocess/wall_output.h>
#include <lahar/simulator/run_output.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/ranks.h>

#include <filesystem>

namespace Lahar
{
  template <int dim>
  RunOutput<dim>::RunOutput(const RunParameters &parameters, Parameters &prm, const MPI_Comm &communicator)
    : communicator(communicator)
    , parameters(parameters)
    , prm(prm)
    , directory(prm.get("Output directory"))
    , statistics(prm.get("Output directory") + "/statistics")
    , convergence(prm.get("Output directory") + "/convergence")
    , visualization(prm.get("Output directory"), communicator)
  {}



  template <int dim>
  void RunOutput<dim>::parse_parameters()
  {
    last_time      = parameters.start_time;
    postprocessors = Postprocessor<dim>::create_all(prm);
    fields         = OutputField<dim>::create_all(prm);
  }



  template <int dim>
  void RunOutput<dim>::take_directory(const OutputDirectory::Use use)
  {
    on_first_rank(communicator, [&] { directory.take(use); });
  }



  template <int dim>
  void RunOutput<dim>::initialize(const Snapshot<dim> &snapshot)
  {
    for (const auto &postprocessor : postprocessors)
      postprocessor->initialize(snapshot);
    StatisticsTable line;
    time_means.start_step(1.);
    for (const auto &postprocessor : postprocessors)
      postprocessor->evaluate(snapshot, line);
    time_means.restart();
    if (const std::string column = line.doubled_column(); !column.empty())
      throw InputError("Two columns of the statistics are called '" + column +
                       "'. Allowed: different names of boundaries, solids, gauges, extents and boxes.");
  }



  template <int dim>
  void RunOutput<dim>::begin(const Snapshot<dim> &snapshot, const std::string &sizes)
  {
    on_first_rank(communicator, [&] {
      directory.clear();
      directory.remove_temporaries();
      write_parameters();
    });
    progress = std::make_unique<Progress>(communicator, parameters.output_directory, parameters.start_time,
                                          parameters.end_time, 0.);
    set_failure_log(parameters.output_directory + "/log");
    progress->message(sizes);
    on_first_rank(communicator, [&] {
      statistics.begin();
      convergence.begin();
      convergence.append("# step, time (s), iteration, relative increments of velocity and pressure\n");
    });
    visualization.write_walls(snapshot.walls);
    write_snapshot(snapshot);
  }



  template <int dim>
  void RunOutput<dim>::write_start(const Snapshot<dim> &snapshot, const std::string &sizes)
  {
    on_first_rank(communicator, [&] {
      if (const std::string file = directory.file_of_run(); !file.empty())
        throw InputError("Option --write-start is '" + parameters.output_directory +
                         "'. Allowed: a directory without a run, but there is '" + file + "'.");
      directory.take(OutputDirectory::Use::overwrite);
      directory.clear();
      write_parameters();
      write_atomically(parameters.output_directory + "/log",
                       [&](std::ostream &file) { file << sizes << '\n'; });
    });
    visualization.write_walls(snapshot.walls);
    visualization.write(snapshot, fields);
    release_directory();
  }



  template <int dim>
  void RunOutput<dim>::resume(const double time, const unsigned int n_steps, const std::string &sizes)
  {
    on_first_rank(communicator, [&] {
      directory.remove_temporaries();
      write_parameters();
    });
    progress = std::make_unique<Progress>(communicator, parameters.output_directory, parameters.start_time,
                                          parameters.end_time, earlier_wall_time);
    set_failure_log(parameters.output_directory + "/log");
    bool complete = true;
    on_first_rank(communicator, [&] {
      complete = statistics.resume(statistics_size);
      convergence.resume(convergence_size);
    });
    if (!complete)
      progress->message("Warning: '" + parameters.output_directory +
                        "/statistics' is not there. It begins anew, without the lines so far.");
    progress->message("Resumed after step " + std::to_string(n_steps) + " at " + std::to_string(time) +
                      " s.\n" + sizes);
    const double due = last_time;
    advance(time);
    // Means over another interval.
    if (last_time != due)
      time_means.restart();
  }



  template <int dim>
  void RunOutput<dim>::check_resumed() const
  {
    statistics.check(statistics_size);
    convergence.check(convergence_size);
  }



  template <int dim>
  void RunOutput<dim>::write_parameters() const
  {
    write_atomically(parameters.output_directory + "/parameters.prm",
                     [&](std::ostream &file) { prm.print_parameters(file, ParameterHandler::PRM); });
  }



  template <int dim>
  void RunOutput<dim>::mend(const Walls<dim> &walls)
  {
    std::string news;
    on_first_rank(communicator, [&] {
      const auto say        = [&](const std::string &text) { news += (news.empty() ? "" : "\n") + text; };
      const auto say_mended = [&](const std::string &name) {
        say("Warning: '" + parameters.output_directory + "/" + name +
            "' was removed while the run wrote to it. It is there again, with all lines.");
      };
      if (const std::string text = directory.mend(); !text.empty())
        say(text);
      if (progress->mend_log())
        say_mended("log");
      if (statistics.mend())
        say_mended("statistics");
      if (convergence.mend())
        say_mended("convergence");
      std::error_code error;
      if (!std::filesystem::exists(parameters.output_directory + "/parameters.prm", error))
      {
        write_parameters();
        say_mended("parameters.prm");
      }
      const std::string walls_file = parameters.output_directory + "/walls.vtu";
      if (!walls.facets().empty() && !any_moves(walls) && !std::filesystem::exists(walls_file, error))
      {
        write_atomically(walls_file, [&](std::ostream &file) { write_walls_vtu(walls, file); });
        say_mended("walls.vtu");
      }
    });
    progress->message(news);
  }



  template <int dim>
  void RunOutput<dim>::advance(const double time)
  {
    const double rounding = 1e-10 * parameters.time_step;
    while (parameters.output_interval > 0. && next_time() < time + rounding)
      last_time += parameters.output_interval;
  }



  template <int dim>
  void RunOutput<dim>::write_snapshot(const Snapshot<dim> &snapshot)
  {
    progress->message(visualization.write(snapshot, fields));
  }



  template <int dim>
  void RunOutput<dim>::write_due_snapshot(const Snapshot<dim> &snapshot)
  {
    const double rounding = 1e-10 * parameters.time_step;
    const bool is_due     = parameters.output_interval <= 0. || snapshot.time >= next_time() - rounding;
    if (!is_due && snapshot.time < parameters.end_time - rounding)
      return;
    write_snapshot(snapshot);
    // A run that ends between two snapshots may go on, and its means with it.
    if (is_due)
      time_means.restart();
    advance(snapshot.time);
  }



  template <int dim>
  void RunOutput<dim>::write_statistics(TableHandler &line, const Snapshot<dim> &snapshot,
                                        const std::string &convergence_lines)
  {
    for (const auto &postprocessor : postprocessors)
      postprocessor->evaluate(snapshot, line);
    add_to_column(line, "Wall time (s)", progress->wall_time());
    mend(snapshot.walls);
    on_first_rank(communicator, [&] {
      statistics.append((statistics.size() == 0 ? statistics_header(line) : "") + statistics_line(line));
      convergence.append(convergence_lines);
    });
  }



  template <int dim>
  void RunOutput<dim>::failure(const std::string &reason) noexcept
  {
    if (progress != nullptr)
      progress->failure(reason);
  }



  template <int dim>
  void RunOutput<dim>::note_sizes()
  {
    earlier_wall_time = progress->wall_time();
    statistics_size   = statistics.size();
    convergence_size  = convergence.size();
  }



  template <int dim>
  void RunOutput<dim>::sync() const
  {
    statistics.sync();
    convergence.sync();
  }



  template class RunOutput<2>;
  template class RunOutput<3>;
} // namespace Lahar
