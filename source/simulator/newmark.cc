// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/time_rule.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * Newmark's rule as of Wood, Bossak & Zienkiewicz (Int. J. Numer. Meth. Engng. 15 (1980) 1562–1566), γ ≥ 1/2,
   * α = 1/2 − γ, β = (1/2 + γ)²/4:
   *
   *   w     = v_n + Δt [(1/2 − β) a_n + β a],
   *   v     = v_n + Δt [(1 − γ) a_n + γ a],
   *   dv/dt = (1 − α) a + α a_n.
   *
   * It is of second order for every γ. What remeshing and impacts leave in v that the incompressible fluid cannot follow
   * is multiplied by ρ = (3/2 − γ)/(1/2 + γ) in every step: γ = 1/2 is the trapezoidal rule, which never forgets it,
   * γ = 3/2 has forgotten it after two steps and equals the backward differences of second order.
   *
   * The first step of a run knows no a_n: the acceleration is constant in it, w = v_n + Δt/2 a, v = v_n + Δt a.
   */
  class Newmark : public TimeRule
  {
  public:
    TimeCoefficients coefficients(const double gamma, const bool is_first) const override
    {
      if (is_first)
        return {0., 0.5, 1., 0.};
      const double beta = 0.25 * (0.5 + gamma) * (0.5 + gamma);
      return {0.5 - gamma, beta, gamma, (0.5 - beta) / beta};
    }
  };



  static const Factory<TimeRule>::Registration<Newmark>
    newmark("Newmark", "Second order, as of Wood, Bossak and Zienkiewicz.");
} // namespace Lahar
