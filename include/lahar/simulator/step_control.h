// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_step_control_h
#define lahar_simulator_step_control_h

#include <algorithm>

namespace Lahar
{
  /**
   * The length of the time steps.
   *
   * A step that fails is repeated with half its length, down to a smallest one. Steps become longer again, by a factor
   * of two and up to the largest length, after three easy ones in a row: such that take at most 0.4 of the allowed
   * nonlinear iterations. Longer than usual they are only as far as no particle moves by more than a tenth of its
   * spacing. Where particles would move too far, a step is halved beforehand. Steps end exactly on the times at which
   * something is due.
   */
  class StepControl
  {
  public:
    /// @param usual,smallest,largest lengths, s; the first step has the usual one. @param maximum_iterations with more,
    /// a step has failed.
    StepControl(const double usual, const double smallest, const double largest,
                const unsigned int maximum_iterations);

    /**
     * Length of the next step from @p time, s; it does not pass @p stop. A rest below 1 % of the step joins it.
     * @param fastest the largest ratio of speed and spacing, 1/s.
     * @param largest_movement in units of the spacing; halves of the step are taken, down to the smallest length, while
     * particles would move farther.
     */
    double next(const double time, const double stop, const double fastest,
                const double largest_movement) const;

    /// Where steps stop, s: at @p due, or at @p end where that comes before or less than 1 % of a usual step later, so that
    /// no tiny step is left.
    double stop(const double due, const double end) const;

    /// A step of the length @p tried has failed: halve it. @return false if that is too short.
    bool halve(double &tried);

    /// A step was accepted after @p iterations.
    void accept(const unsigned int iterations);

    /// A length that was shortened stays so when it is read with another usual length.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      double old_usual = usual;
      archive &old_usual &present &n_easy;
      if (old_usual != usual)
        present *= usual / old_usual;
      present = std::min(present, largest);
    }

  private:
    double usual, smallest, largest, present;
    double easy_iterations;
    unsigned int n_easy = 0;
  };
} // namespace Lahar

#endif
