#include <lahar/simulator/simulator.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/ranks.h>

#include <filesystem>

namespace Lahar
{
  template <int dim>
  void Simulator<dim>::start_output()
  {
    const std::string &directory = parameters.output_directory;
    progress = std::make_unique<Progress>(directory, parameters.start_time, parameters.end_time,
                                          earlier_wall_time, !is_first_rank(communicator));
    last_checkpoint_wall_time = progress->wall_time();
    if (resumed)
    {
      on_first_rank(communicator, [&] {
        std::error_code ignored; // without the file it is begun anew
        std::filesystem::resize_file(directory + "/convergence", convergence_size, ignored);
        convergence.open(directory + "/convergence", std::ios::app);
      });
      progress->message("Resumed after step " + std::to_string(step_number) + " at " + std::to_string(time) +
                        " s.\n" + sizes());
      advance_output_time(); // the interval may be another one
      return;
    }
    visualization = std::make_unique<Visualization<dim>>(directory);
    progress->message(sizes());
    on_first_rank(communicator, [&] {
      checkpoint.remove();
      convergence.open(directory + "/convergence");
      convergence << "# step, time (s), iteration, relative increments of velocity and pressure\n"
                  << std::flush;
      visualization->write(snapshot());
    });
    last_output_time = parameters.start_time;
  }



  template <int dim>
  void Simulator<dim>::advance_output_time()
  {
    const double rounding = 1e-10 * parameters.time_step;
    while (parameters.output_interval > 0. && last_output_time + parameters.output_interval < time + rounding)
      last_output_time += parameters.output_interval;
  }



  template <int dim>
  void Simulator<dim>::write_output()
  {
    on_first_rank(communicator, [this] { visualization->write(snapshot()); });
    write_statistics();
  }



  template <int dim>
  Snapshot<dim> Simulator<dim>::snapshot() const
  {
    return {particles, fluid_mesh, *law, gravity, wall_forces, solids, solid_forces, time};
  }



  template <int dim>
  void Simulator<dim>::add_statistics(const double time_step, const NonlinearReport &report)
  {
    statistics.add_value("Time step number", step_number);
    add_to_column(statistics, "Time (s)", time);
    add_to_column(statistics, "Time step size (s)", time_step);
    statistics.add_value("Nonlinear iterations", report.iterations);
    add_to_column(statistics, "Velocity increment", report.velocity_increment);
    add_to_column(statistics, "Pressure increment", report.pressure_increment);
    add_to_column(statistics, "Momentum residual (N)", report.momentum_residual);
    add_to_column(statistics, "Mass residual (m^dim/s)", report.mass_residual);
    for (unsigned int i = 0; i < report.increments.size() && convergence.is_open(); ++i)
      convergence << step_number << ' ' << time << ' ' << i + 1 << ' ' << report.increments[i].first << ' '
                  << report.increments[i].second << '\n';
    statistics.add_value("Linear iterations", report.linear_iterations);
    statistics.add_value("Held vertices", report.n_held);
    statistics.add_value("Fluid cells", fluid_mesh.n_cells());
    statistics.add_value("Solid cells", solids.mesh().n_cells());
    statistics.add_value("Fluid particles", particles.n_particles(ParticleKind::fluid));
    add_to_column(statistics, "Fluid volume (m^dim)", volume);
    add_to_column(statistics, "Volume change by solver", change_by_solver);
    add_to_column(statistics, "Volume change by remeshing", change_by_remeshing);
    statistics.add_value("Remeshed", static_cast<unsigned int>(remeshing.changed));
    statistics.add_value("Rejected steps", n_rejected);
    if (!solids.empty())
    {
      statistics.add_value("Mended contour facets", n_forced_facets);
      statistics.add_value("Particles kept out of solids", n_kept_out);
    }
    if (domain_limit.is_set())
    {
      statistics.add_value("Particles left the domain", n_left);
      add_to_column(statistics, "Volume left the domain", left_volume);
    }
    for (const auto &postprocessor : postprocessors)
      postprocessor->evaluate(snapshot(), statistics);
    add_to_column(statistics, "Wall time (s)", progress->wall_time());

    progress->step({step_number, time, time_step, report.iterations, report.velocity_increment,
                    report.pressure_increment, fluid_mesh.n_cells(), change_by_solver + change_by_remeshing});
  }



  template <int dim>
  void Simulator<dim>::write_statistics()
  {
    on_first_rank(communicator, [this] {
      write_atomically(parameters.output_directory + "/statistics", [this](std::ostream &file) {
        statistics.write_text(file, TableHandler::table_with_separate_column_description);
      });
    });
  }



  template void Simulator<2>::start_output();
  template void Simulator<3>::start_output();
  template void Simulator<2>::advance_output_time();
  template void Simulator<3>::advance_output_time();
  template void Simulator<2>::write_output();
  template void Simulator<3>::write_output();
  template Snapshot<2> Simulator<2>::snapshot() const;
  template Snapshot<3> Simulator<3>::snapshot() const;
  template void Simulator<2>::add_statistics(const double, const NonlinearReport &);
  template void Simulator<3>::add_statistics(const double, const NonlinearReport &);
  template void Simulator<2>::write_statistics();
  template void Simulator<3>::write_statistics();
} // namespace Lahar
