// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/progress.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/ranks.h>

#include <unistd.h>

#include <cstdio>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace Lahar
{
  namespace
  {
    std::string duration(const double seconds)
    {
      char text[32];
      const long s = static_cast<long>(seconds + 0.5);
      std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
      return text;
    }
  } // namespace



  Progress::Progress(const MPI_Comm &communicator, const std::string &directory, const double start_time,
                     const double end_time, const double earlier_wall_time)
    : communicator(communicator)
    , log(directory + "/log")
    , on_terminal(isatty(STDOUT_FILENO))
    , start_time(start_time)
    , end_time(end_time)
    , earlier_wall_time(earlier_wall_time)
    , start(std::chrono::steady_clock::now())
  {
    on_first_rank(communicator, [&] {
      if (earlier_wall_time > 0.)
        log.go_on();
      else
        log.begin();
    });
  }



  double Progress::wall_time() const
  {
    return earlier_wall_time +
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }



  void Progress::step(const Line &line)
  {
    const double done      = (line.time - start_time) / (end_time - start_time);
    const std::string left = duration(wall_time() * (1. - done) / done);

    std::ostringstream text;
    text << "step " << std::setw(6) << line.step << "  t = " << std::setw(10) << std::setprecision(6)
         << line.time << " s  dt = " << std::setprecision(3) << line.time_step << " s  iterations "
         << std::setw(2) << line.iterations << "  dv " << std::scientific << std::setprecision(1)
         << line.velocity_increment << "  dp " << line.pressure_increment << std::defaultfloat << "  cells "
         << line.cells << "  volume " << std::showpos << std::fixed << std::setprecision(3)
         << 100. * line.volume_error << " %" << std::noshowpos << "  left " << left;
    on_first_rank(communicator, [&] {
      log.append(text.str() + '\n');
      if (screen.exists())
        show(line, done, left);
      else if (on_terminal)
        std::cout << text.str() << std::endl;
    });
  }



  void Progress::show(const Line &line, const double done, const std::string &left)
  {
    const auto number = [](const char *format, const double value) {
      char text[32];
      std::snprintf(text, sizeof(text), format, value);
      return std::string(text);
    };
    screen.show({{number("%3.0f %%", 100. * done), 4},
                 {"t = " + number("%.5g", line.time) + " of " + number("%.5g s", end_time), 3},
                 {"step " + std::to_string(line.step), 2},
                 {"iterations " + number("%2.0f", line.iterations), 0},
                 {"volume " + number("%+.3f %%", 100. * line.volume_error), 1},
                 {"left " + left, 5}});
  }



  void Progress::message(const std::string &text)
  {
    on_first_rank(communicator, [&] {
      if (text.empty())
        return;
      log.append(text + '\n');
      screen.message(text);
    });
  }



  void Progress::failure(const std::string &reason) noexcept
  {
    screen.finish();
    try
    {
      if (is_first_rank(communicator))
        log.append("The run failed. " + reason + '\n');
    }
    catch (const RunError &)
    {
      // It is the first failure that counts.
    }
  }



  bool Progress::mend_log()
  {
    return log.mend(false); // people may shorten it
  }



  void Progress::summary(const TimerOutput &timer, const double cell_steps)
  {
    std::ostringstream table;
    table << "\nTimes by phase\n";
    double all = 0.;
    for (const auto &[phase, seconds] : timer.get_summary_data(TimerOutput::total_wall_time))
    {
      table << "  " << std::left << std::setw(20) << phase << std::right << std::fixed << std::setprecision(2)
            << std::setw(10) << seconds << " s" << std::setw(10) << std::setprecision(3)
            << 1e6 * seconds / cell_steps << " us per cell and step\n";
      all += seconds;
    }
    table << "  " << std::left << std::setw(20) << "All" << std::right << std::fixed << std::setprecision(2)
          << std::setw(10) << all << " s" << std::setw(10) << std::setprecision(3) << 1e6 * all / cell_steps
          << " us per cell and step";
    screen.finish();
    message(table.str());
  }
} // namespace Lahar
