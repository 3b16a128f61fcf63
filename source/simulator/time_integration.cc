// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/time_integration.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  void TimeIntegration::declare_parameters(Parameters &prm)
  {
    Factory<TimeRule>::declare_choice(prm, "Time integration", "Newmark", "Rule of the time integration.");
    Factory<TimeRule>::declare_parameters(prm);
    prm.declare_number(
      "Newmark gamma", "1.5",
      "Newmark's γ, 0.5 to 1.5. 0.5 is the trapezoidal rule, which damps nothing; larger values damp the "
      "oscillation of pressures and accelerations from step to step by the factor (1.5−γ)/(0.5+γ). The rule is of second "
      "order for all.",
      0.5, 1.5);
  }



  void TimeIntegration::parse_parameters(Parameters &prm)
  {
    rule          = Factory<TimeRule>::create(Factory<TimeRule>::choice(prm, "Time integration"), prm);
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
    Assert(rule, ExcMessage("The rule is not known before parse_parameters()."));
    time_step    = new_time_step;
    is_first     = new_is_first;
    coefficients = rule->coefficients(newmark_gamma, is_first);
  }
} // namespace Lahar
