#include <lahar/simulator/time_integration.h>

namespace Lahar
{
  void TimeIntegration::declare_parameters(Parameters &prm)
  {
    prm.declare_entry(
      "Time integration", "Newmark", Patterns::Anything(),
      "Time integration: 'Newmark' (trapezoidal rule, second order, undamped) or 'backward Euler' "
      "(first order, damped).");
  }



  void TimeIntegration::parse_parameters(Parameters &prm)
  {
    if (prm.get("Time integration") != "Newmark" && prm.get("Time integration") != "backward Euler")
      prm.throw_wrong_value("Time integration", "Newmark|backward Euler");
    newmark = prm.get("Time integration") == "Newmark";
  }



  void TimeIntegration::start_step(const double new_time_step, const bool is_first)
  {
    time_step   = new_time_step;
    trapezoidal = newmark && !is_first;
  }



  StepFactors TimeIntegration::factors() const
  {
    return trapezoidal ? StepFactors{time_step, 0.5 * time_step, 2. / time_step}
                       : StepFactors{time_step, time_step, 1. / time_step};
  }
} // namespace Lahar
