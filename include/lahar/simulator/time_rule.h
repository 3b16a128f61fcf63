// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_time_rule_h
#define lahar_simulator_time_rule_h

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * What the formulas of TimeIntegration take from a rule: with a_n and a at the start and at the end of the step,
   *
   *   w     = v_n + Δt β (a + c a_n),   c = (1/2 − β)/β where the rule has a_n at all,
   *   v     = v_n + Δt [(1 − γ) a_n + γ a],
   *   dv/dt = (1 − α) a + α a_n.
   */
  struct TimeCoefficients
  {
    double alpha = 0., beta = 1., gamma = 1.;
    double old_factor = 0.; ///< c
  };

  /**
   * A rule of TimeIntegration, by its coefficients. It registers itself with Factory<TimeRule>; its entries stand in the
   * subsection of its name.
   */
  class TimeRule
  {
  public:
    virtual ~TimeRule() = default;

    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// @param newmark_gamma γ of Newmark's rule, the solids' differs from the fluid's; others ignore it.
    /// @param is_first whether the step is a run's first one, which knows no a_n.
    virtual TimeCoefficients coefficients(const double newmark_gamma, const bool is_first) const = 0;
  };
} // namespace Lahar

#endif
