// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/statistics_line.h>
#include <lahar/postprocess/wall_output.h>
#include <lahar/simulator/simulator.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/ranks.h>

#include <filesystem>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// The account of the volume is a matter for a warning beyond this part of the volume at the start.
    constexpr double largest_quiet_change = 0.01;
  } // namespace



  template <int dim>
  void Simulator<dim>::take_output_directory(const OutputDirectory::Use use)
  {
    on_first_rank(communicator, [&] { directory.take(use); });
  }



  template <int dim>
  void Simulator<dim>::start_output()
  {
    on_first_rank(communicator, [&] {
      if (!resumed)
        directory.clear();
      directory.remove_temporaries();
      write_parameters();
    });
    progress = std::make_unique<Progress>(communicator, parameters.output_directory, parameters.start_time,
                                          parameters.end_time, earlier_wall_time);
    set_failure_log(parameters.output_directory + "/log");
    last_checkpoint_wall_time = progress->wall_time();
    if (resumed)
    {
      bool complete = true;
      on_first_rank(communicator, [&] {
        complete = statistics.resume(statistics_size);
        convergence.resume(convergence_size);
      });
      if (!complete)
        progress->message("Warning: '" + parameters.output_directory +
                          "/statistics' is not there. It begins anew, without the lines so far.");
      progress->message("Resumed after step " + std::to_string(step_number) + " at " + std::to_string(time) +
                        " s.\n" + sizes());
      advance_output_time(); // the interval may be another one
      return;
    }
    visualization = std::make_unique<Visualization<dim>>(parameters.output_directory, communicator);
    progress->message(sizes());
    on_first_rank(communicator, [&] {
      statistics.begin();
      convergence.begin();
      convergence.append("# step, time (s), iteration, relative increments of velocity and pressure\n");
    });
    visualization->write_walls(walls);
    write_snapshot();
    last_output_time = parameters.start_time;
  }



  template <int dim>
  void Simulator<dim>::write_parameters() const
  {
    write_atomically(parameters.output_directory + "/parameters.prm",
                     [&](std::ostream &file) { prm.print_parameters(file, ParameterHandler::PRM); });
  }



  template <int dim>
  void Simulator<dim>::mend_output()
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
      const std::string walls_file = parameters.output_directory + "/walls.vtu";
      if (!std::filesystem::exists(parameters.output_directory + "/parameters.prm", error))
      {
        write_parameters();
        say_mended("parameters.prm");
      }
      if (!walls.facets().empty() && !std::filesystem::exists(walls_file, error))
      {
        write_atomically(walls_file, [&](std::ostream &file) { write_walls_vtu(walls, file); });
        say_mended("walls.vtu");
      }
    });
    progress->message(news);
  }



  template <int dim>
  void Simulator<dim>::advance_output_time()
  {
    const double rounding = 1e-10 * parameters.time_step;
    while (parameters.output_interval > 0. && last_output_time + parameters.output_interval < time + rounding)
      last_output_time += parameters.output_interval;
  }



  template <int dim>
  void Simulator<dim>::write_snapshot()
  {
    progress->message(visualization->write(snapshot()));
    means.restart();
  }



  template <int dim>
  Snapshot<dim> Simulator<dim>::snapshot()
  {
    return {particles, fluid_mesh, *law, gravity, solids, migration, means, time};
  }



  template <int dim>
  void Simulator<dim>::add_statistics(const double time_step, const NonlinearReport &report)
  {
    TableHandler line;
    line.add_value("Time step number", step_number);
    add_to_column(line, "Time (s)", time);
    add_to_column(line, "Time step size (s)", time_step);
    line.add_value("Nonlinear iterations", report.iterations);
    add_to_column(line, "Velocity increment", report.velocity_increment);
    add_to_column(line, "Pressure increment", report.pressure_increment);
    add_to_column(line, "Momentum residual (N)", report.momentum_residual);
    add_to_column(line, "Mass residual (m^dim/s)", report.mass_residual);
    line.add_value("Linear iterations", report.linear_iterations);
    line.add_value("Held vertices", report.n_held);
    line.add_value("Fluid cells", n_cells);
    line.add_value("Solid cells", solids.mesh().n_cells());
    line.add_value("Fluid particles", count_on_ranks(particles.n_particles(ParticleKind::fluid)));
    add_to_column(line, "Fluid volume (m^dim)", volume);
    add_to_column(line, "Volume change by solver", change_by_solver);
    add_to_column(line, "Volume change by remeshing", change_by_remeshing);
    line.add_value("Remeshed", static_cast<unsigned int>(remeshing.changed));
    line.add_value("Rejected steps", n_rejected);
    if (!solids.empty())
    {
      line.add_value("Mended contour facets", n_forced_facets);
      line.add_value("Particles kept out of solids", n_kept_out);
    }
    if (domain_limit.is_set())
    {
      line.add_value("Particles left the domain", n_left);
      add_to_column(line, "Volume left the domain", left_volume);
    }
    if (geometry.has_fluid())
      momentum.add_columns(line);
    means.start_step(time_step);
    for (const auto &postprocessor : postprocessors)
      postprocessor->evaluate(snapshot(), line);
    add_to_column(line, "Wall time (s)", progress->wall_time());

    mend_output();
    on_first_rank(communicator, [&] {
      statistics.append((statistics.size() == 0 ? statistics_header(line) : "") + statistics_line(line));
      std::ostringstream increments;
      for (unsigned int i = 0; i < report.increments.size(); ++i)
        increments << step_number << ' ' << time << ' ' << i + 1 << ' ' << report.increments[i].first << ' '
                   << report.increments[i].second << '\n';
      convergence.append(increments.str());
    });
    warn_of_volume();
    progress->step({step_number, time, time_step, report.iterations, report.velocity_increment,
                    report.pressure_increment, n_cells, change_by_solver + change_by_remeshing});
  }



  template <int dim>
  void Simulator<dim>::warn_of_volume()
  {
    if (warned_of_volume || std::abs(change_by_solver + change_by_remeshing) < largest_quiet_change)
      return;
    warned_of_volume = true;
    // Where the surface owes or is owed most of what remeshing could not take back.
    double largest = 0.;
    Point<dim> place;
    for (unsigned int i = 0; i < particles.size(); ++i)
      if (particles.is_own(i) && std::abs(particles.owed_volume[i]) > largest)
      {
        largest = std::abs(particles.owed_volume[i]);
        place   = particles.position[i];
      }
    place = largest_of_all(largest, place, communicator).second;
    std::ostringstream text;
    text << "Warning: time " << time << " s: the fluid's volume has changed by "
         << 100. * (change_by_solver + change_by_remeshing) << " %, of which the solver "
         << 100. * change_by_solver << " % and remeshing " << 100. * change_by_remeshing << " %";
    if (largest_of_all(largest, place, communicator).first > 0.)
      text << ", most of it around (" << place << ") m";
    text << ". A smaller 'Mesh size' resolves what splashes and merges.";
    progress->message(text.str());
  }



  template void Simulator<2>::take_output_directory(const OutputDirectory::Use);
  template void Simulator<3>::take_output_directory(const OutputDirectory::Use);
  template void Simulator<2>::start_output();
  template void Simulator<3>::start_output();
  template void Simulator<2>::mend_output();
  template void Simulator<3>::mend_output();
  template void Simulator<2>::advance_output_time();
  template void Simulator<3>::advance_output_time();
  template void Simulator<2>::write_snapshot();
  template void Simulator<3>::write_snapshot();
  template Snapshot<2> Simulator<2>::snapshot();
  template Snapshot<3> Simulator<3>::snapshot();
  template void Simulator<2>::add_statistics(const double, const NonlinearReport &);
  template void Simulator<3>::add_statistics(const double, const NonlinearReport &);
} // namespace Lahar
