// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/simulator.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/stop_signal.h>

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
      output.failure(Failure::current().message);
      output.release_directory(); // what comes now may end the process at once
      throw;
    }
  }



  template <int dim>
  void Simulator<dim>::compute()
  {
    start_output();
    double cell_steps     = 0.;
    const double rounding = 1e-10 * input.run.time_step;
    int signal            = 0;
    bool interrupted      = false; // in the middle of a step
    while (time < input.run.end_time - rounding && (signal = StopSignal::received(communicator())) == 0)
    {
      {
        TimerOutput::Scope scope(timer, "Keep state");
        keep_state();
      }
      try
      {
        step(step_control->next(time,
                                input.run.output_interval > 0.
                                  ? step_control->stop(output.next_time(), input.run.end_time)
                                  : input.run.end_time,
                                fastest_movement(), input.run.largest_movement));
      }
      catch (const StopRequest &)
      {
        signal      = StopSignal::received(communicator());
        interrupted = true;
        break;
      }
      cell_steps += account.counters.cells;

      TimerOutput::Scope scope(timer, "Output");
      output.write_due_snapshot(snapshot());
      write_due_checkpoint();
    }
    if (!interrupted)
      keep_state();
    write_kept_state();
    if (signal != 0)
      output.message(StopSignal::name(signal) + ": stopped after step " +
                     std::to_string(account.counters.steps) + " at " + std::to_string(time) +
                     " s. Option --resume goes on from here.");
    if (const std::string text = account.ill_posed_cells.warning(communicator()); !text.empty())
      output.message(text);
    if (cell_steps > 0.)
      output.summary(timer, cell_steps);
  }



  template void Simulator<2>::run();
  template void Simulator<3>::run();
} // namespace Lahar
