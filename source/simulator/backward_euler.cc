// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/time_rule.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// v = w, dv/dt = a = (w − v_n)/Δt: first order, in the first step, too.
  class BackwardEuler : public TimeRule
  {
  public:
    TimeCoefficients coefficients(const double /*newmark_gamma*/, const bool /*is_first*/) const override
    {
      return {};
    }
  };



  static const Factory<TimeRule>::Registration<BackwardEuler> backward_euler("backward Euler",
                                                                             "First order, strongly damped.");
} // namespace Lahar
