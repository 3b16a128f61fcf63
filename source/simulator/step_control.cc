// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/step_control.h>

namespace Lahar
{
  namespace
  {
    constexpr double easy_part              = 0.4;
    constexpr unsigned int n_easy_to_grow   = 3;
    constexpr double rest_that_joins_a_step = 0.01;
    /// No particle moves by more than this times its spacing in a step longer than usual.
    constexpr double movement_in_long_steps = 0.1;
  } // namespace



  StepControl::StepControl(const double usual, const double smallest, const double largest,
                           const unsigned int maximum_iterations)
    : usual(usual)
    , smallest(smallest)
    , largest(largest)
    , present(usual)
    , easy_iterations(easy_part * maximum_iterations)
  {}



  double StepControl::next(const double time, const double stop, const double fastest,
                           const double largest_movement) const
  {
    double length = present;
    if (length > usual)
      length = std::max(usual, std::min(length, movement_in_long_steps / fastest));
    while (length * fastest > largest_movement && 0.5 * length >= smallest)
      length *= 0.5;
    return time + (1. + rest_that_joins_a_step) * length > stop ? stop - time : length;
  }



  double StepControl::stop(const double due, const double end) const
  {
    return due + rest_that_joins_a_step * usual > end ? end : due;
  }



  bool StepControl::halve(double &tried)
  {
    tried *= 0.5;
    present = std::min(present, tried);
    n_easy  = 0;
    return tried >= smallest;
  }



  void StepControl::accept(const unsigned int iterations)
  {
    n_easy = iterations <= easy_iterations ? n_easy + 1 : 0;
    if (n_easy >= n_easy_to_grow && present < largest)
    {
      present = std::min(2. * present, largest);
      n_easy  = 0;
    }
  }
} // namespace Lahar
