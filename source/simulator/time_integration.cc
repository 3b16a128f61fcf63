// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/time_integration.h>

namespace Lahar
{
  void TimeIntegration::declare_parameters(Parameters &prm)
  {
    prm.declare_entry(
      "Time integration", "Newmark", Patterns::Anything(),
      "Time integration: 'Newmark' (with trapezoidal displacements) or 'backward Euler' (first order, "
      "strongly damped).");
    prm.declare_entry(
      "Newmark gamma", "0.7", Patterns::Anything(),
      "Newmark's γ, 0.5 to 1. 0.5 is the trapezoidal rule, which damps nothing; larger values damp the "
      "oscillation of pressures and accelerations from step to step by the factor (1−γ)/γ.");
  }



  void TimeIntegration::parse_parameters(Parameters &prm)
  {
    if (prm.get("Time integration") != "Newmark" && prm.get("Time integration") != "backward Euler")
      prm.throw_wrong_value("Time integration", "Newmark|backward Euler");
    newmark       = prm.get("Time integration") == "Newmark";
    newmark_gamma = prm.get_in_range("Newmark gamma", 0.5, 1.);
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
  }



  StepFactors TimeIntegration::factors() const
  {
    return {time_step, 1. / (gamma * time_step)};
  }
} // namespace Lahar
