// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/time_integration.h>

namespace Lahar
{
  void TimeIntegration::declare_parameters(Parameters &prm)
  {
    prm.declare_entry(
      "Time integration", "Newmark", Patterns::Anything(),
      "Time integration: 'Newmark' (second order, as of Wood, Bossak and Zienkiewicz) or 'backward "
      "Euler' (first order, strongly damped).");
    prm.declare_entry(
      "Newmark gamma", "1.5", Patterns::Anything(),
      "Newmark's γ, 0.5 to 1.5. 0.5 is the trapezoidal rule, which damps nothing; larger values damp the "
      "oscillation of pressures and accelerations from step to step by the factor (1.5−γ)/(0.5+γ). The rule is of second "
      "order for all.");
  }



  void TimeIntegration::parse_parameters(Parameters &prm)
  {
    if (prm.get("Time integration") != "Newmark" && prm.get("Time integration") != "backward Euler")
      prm.throw_wrong_value("Time integration", "Newmark|backward Euler");
    newmark       = prm.get("Time integration") == "Newmark";
    newmark_gamma = prm.get_in_range("Newmark gamma", 0.5, 1.5);
  }



  TimeIntegration TimeIntegration::with_gamma(const double other_gamma) const
  {
    TimeIntegration other = *this;
    other.newmark_gamma   = other_gamma;
    other.start_step(time_step, is_first);
    return other;
  }



  void TimeIntegration::start_step(const double new_time_step, const bool new_is_first)
  {
    time_step = new_time_step;
    is_first  = new_is_first;
    gamma     = newmark && !is_first ? newmark_gamma : 1.;
    alpha     = newmark && !is_first ? 0.5 - gamma : 0.;
    beta      = !newmark ? 1. : is_first ? 0.5 : 0.25 * (0.5 + gamma) * (0.5 + gamma);
    // Backward Euler and the first step do without a_n.
    old_factor = newmark && !is_first ? (0.5 - beta) / beta : 0.;
  }
} // namespace Lahar
