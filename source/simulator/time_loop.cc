// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/simulator.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/stop_signal.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void Simulator<dim>::run()
  {
    StopSignal::catch_all();
    try
    {
      compute();
      set_failure_log("");
    }
    catch (...)
    {
      if (progress != nullptr)
        progress->failure(Failure::current().message);
      directory.release(); // what comes now may end the process at once
      throw;
    }
  }



  template <int dim>
  void Simulator<dim>::compute()
  {
    start_output();
    double cell_steps     = 0.;
    const double rounding = 1e-10 * parameters.time_step;
    int signal            = 0;
    bool interrupted      = false; // in the middle of a step
    while (time < parameters.end_time - rounding && (signal = StopSignal::received(communicator)) == 0)
    {
      {
        TimerOutput::Scope scope(timer, "Keep state");
        keep_state();
      }
      const double output_time = last_output_time + parameters.output_interval;
      try
      {
        step(step_control->next(time,
                                parameters.output_interval > 0. ? std::min(output_time, parameters.end_time)
                                                                : parameters.end_time,
                                fastest_movement(), parameters.largest_movement));
      }
      catch (const StopRequest &)
      {
        signal      = StopSignal::received(communicator);
        interrupted = true;
        break;
      }
      cell_steps += n_cells;

      TimerOutput::Scope scope(timer, "Output");
      if (parameters.output_interval == 0. || time >= output_time - rounding ||
          time >= parameters.end_time - rounding)
      {
        write_snapshot();
        advance_output_time();
      }
      if (checkpoint_is_due())
        write_checkpoint();
    }
    if (!interrupted)
      keep_state();
    write_kept_state();
    if (signal != 0)
      progress->message(StopSignal::name(signal) + ": stopped after step " + std::to_string(step_number) +
                        " at " + std::to_string(time) + " s. Option --resume goes on from here.");
    if (cell_steps > 0.)
      progress->summary(timer, cell_steps);
  }



  template void Simulator<2>::run();
  template void Simulator<3>::run();
} // namespace Lahar
