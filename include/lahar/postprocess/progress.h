// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_postprocess_progress_h
#define lahar_postprocess_progress_h

#include <deal.II/base/timer.h>

#include <lahar/utilities/appended_file.h>
#include <lahar/utilities/terminal_line.h>

#include <chrono>
#include <string>

namespace Lahar
{
  using namespace dealii;

  /**
   * Tells people how the run goes: one line a step, into the file `log` and, if the standard output is a terminal, on
   * the screen, where it rewrites itself as a TerminalLine; what matters once goes to both in any case. The first rank
   * does this; all functions but wall_time() and failure() are collective, and throw RunError if `log` cannot be written.
   */
  class Progress
  {
  public:
    /// What the line of a step shows.
    struct Line
    {
      unsigned int step = 0;
      double time = 0., time_step = 0.;
      unsigned int iterations   = 0;
      double velocity_increment = 0., pressure_increment = 0.;
      unsigned int cells  = 0;
      double volume_error = 0.; ///< relative to the initial volume
    };

    /**
     * @param directory where `log` is written; a resumed run appends to it.
     * @param start_time,end_time s, for the estimate of what is left.
     * @param earlier_wall_time what the run took before it was resumed, s; zero for a new one.
     */
    Progress(const MPI_Comm &communicator, const std::string &directory, const double start_time,
             const double end_time, const double earlier_wall_time);

    void step(const Line &line);

    /// A message of its own line(s), on the screen and in the log: the first rank's, if it has one.
    void message(const std::string &text);

    /// Why the run fails, in the log if that can be written: it is on the screen by other ways.
    void failure(const std::string &reason) noexcept;

    /// See AppendedFile::mend(), on the first rank alone.
    bool mend_log();

    /// The table of wall times, and µs per cell and step of each phase.
    void summary(const TimerOutput &timer, const double cell_steps);

    /// Wall time since the start, with that before the run was resumed, s.
    double wall_time() const;

  private:
    /// The line on the screen.
    void show(const Line &line, const double done, const std::string &left);

    MPI_Comm communicator;
    AppendedFile log;
    bool on_terminal;
    TerminalLine screen;
    double start_time, end_time, earlier_wall_time;
    std::chrono::steady_clock::time_point start;
  };
} // namespace Lahar

#endif
