// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/statistics_line.h>
#include <lahar/simulator/simulator.h>

#include <sstream>

namespace Lahar
{
  template <int dim>
  void Simulator<dim>::start_output()
  {
    if (checkpoint.is_resumed())
      output.resume(time, account.counters.steps, sizes());
    else
      output.begin(snapshot(), sizes());
    checkpoint.begin(output.wall_time());
  }



  template <int dim>
  void Simulator<dim>::write_start()
  {
    output.write_start(snapshot(), sizes());
  }



  template <int dim>
  Snapshot<dim> Simulator<dim>::snapshot()
  {
    return {region.particles,
            region.mesh,
            materials,
            input.gravity,
            solids,
            walls,
            migration,
            output.means(),
            time,
            &region.multipliers.table(),
            &outlets.mean_forces()};
  }



  template <int dim>
  void Simulator<dim>::add_statistics(const double time_step, const NonlinearReport &report)
  {
    TableHandler line;
    line.add_value("Time step number", account.counters.steps);
    add_to_column(line, "Time (s)", time);
    add_to_column(line, "Time step size (s)", time_step);
    line.add_value("Nonlinear iterations", report.iterations);
    add_to_column(line, "Velocity increment", report.velocity_increment);
    add_to_column(line, "Pressure increment", report.pressure_increment);
    add_to_column(line, "Momentum residual (N)", report.momentum_residual);
    add_to_column(line, "Mass residual (m^dim/s)", report.mass_residual);
    line.add_value("Linear iterations", report.linear_iterations);
    line.add_value("Held vertices", report.n_held);
    if (input.geometry.has_fluid() && materials.any_yields())
    {
      add_to_column(line, "Yield gap (W)", report.yield_gap);
      add_to_column(line, "Relative yield gap", report.relative_yield_gap);
    }
    line.add_value("Fluid cells", account.counters.cells);
    line.add_value("Solid cells", solids.mesh().n_cells());
    line.add_value("Fluid particles", count_on_ranks(region.particles.n_particles(ParticleKind::fluid)));
    account.volume.add_columns(line);
    account.fluids.add_columns(line);
    line.add_value("Remeshed", static_cast<unsigned int>(region.remeshing.changed));
    line.add_value("Rejected steps", account.counters.rejected);
    if (!solids.empty())
    {
      line.add_value("Mended contour facets", account.counters.forced_facets);
      line.add_value("Particles kept out of solids", account.counters.kept_out);
    }
    if (inlets.any())
    {
      account.volume.add_inflow_column(line);
      account.momentum.add_inflow_columns(line);
    }
    if (outlets.any())
    {
      line.add_value("Particles gone out", account.counters.gone_out);
      account.volume.add_outflow_column(line);
      account.momentum.add_outflow_columns(line);
    }
    if (input.domain_limit.is_set())
    {
      line.add_value("Particles left the domain", account.counters.left);
      account.volume.add_left_column(line);
    }
    if (input.geometry.has_fluid())
      account.momentum.add_columns(line);

    std::ostringstream increments;
    for (unsigned int i = 0; i < report.increments.size(); ++i)
      increments << account.counters.steps << ' ' << time << ' ' << i + 1 << ' ' << report.increments[i].first
                 << ' ' << report.increments[i].second << '\n';
    output.start_step(time_step);
    output.write_statistics(line, snapshot(), increments.str());
    if (const std::string news = account.volume.news(region.particles, time, communicator()); !news.empty())
      output.message(news);
    account.ill_posed_cells.add(snapshot());
    output.step({account.counters.steps, time, time_step, report.iterations, report.velocity_increment,
                 report.pressure_increment, account.counters.cells, account.volume.change()});
  }



  template void Simulator<2>::start_output();
  template void Simulator<3>::start_output();
  template void Simulator<2>::write_start();
  template void Simulator<3>::write_start();
  template Snapshot<2> Simulator<2>::snapshot();
  template Snapshot<3> Simulator<3>::snapshot();
  template void Simulator<2>::add_statistics(const double, const NonlinearReport &);
  template void Simulator<3>::add_statistics(const double, const NonlinearReport &);
} // namespace Lahar
