// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_time_integration_h
#define lahar_simulator_time_integration_h

#include <deal.II/base/tensor.h>

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  using namespace dealii;

  /// How a node moves at one time.
  template <int dim>
  struct Motion
  {
    Tensor<1, dim> velocity;                 ///< v, m/s
    Tensor<1, dim> acceleration;             ///< dv/dt, m/s²
    Tensor<1, dim> algorithmic_acceleration; ///< a of TimeIntegration, m/s²
  };

  /**
   * One-step rules whose unknown is w, the mean velocity of a node in the step: it moves from x_n to x = x_n + Δt w. The
   * volume of a cell at the end of the step is thus a function of w alone, whatever v_n is, and the mass equation keeps
   * it.
   *
   * Newmark's rule as of Wood, Bossak & Zienkiewicz (Int. J. Numer. Meth. Engng. 15 (1980) 1562–1566), γ ≥ 1/2,
   * α = 1/2 − γ, β = (1/2 + γ)²/4:
   *
   *   w     = v_n + Δt [(1/2 − β) a_n + β a],
   *   v     = v_n + Δt [(1 − γ) a_n + γ a],
   *   dv/dt = (1 − α) a + α a_n,
   *
   * all forces at the end of the step. It is of second order for every γ. What remeshing and impacts leave in v that the
   * incompressible fluid cannot follow is multiplied by ρ = (3/2 − γ)/(1/2 + γ) in every step: γ = 1/2 is the trapezoidal
   * rule, which never forgets it, γ = 3/2 has forgotten it after two steps and equals the backward differences of second
   * order.
   *
   * The first step of a run knows no a_n: the acceleration is constant in it, w = v_n + Δt/2 a, v = v_n + Δt a.
   *
   * Backward Euler: v = w, dv/dt = a = (w − v_n)/Δt.
   *
   * A node that is stopped or driven in the step moves impulsively: v = w, dv/dt = (w − v_n)/Δt, and a stays.
   */
  class TimeIntegration
  {
  public:
    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// The same rule, in the same step, with another γ of Newmark's.
    TimeIntegration with_gamma(const double newmark_gamma) const;

    /// Begin a step of length @p time_step (s); @p is_first as said above.
    void start_step(const double time_step, const bool is_first);

    /// Whether the step is a run's first one.
    bool is_first_step() const
    {
      return is_first;
    }

    /// Δt, s.
    double length() const
    {
      return time_step;
    }

    /// ∂v/∂w at the end of the step.
    double velocity_factor(const bool impulsive) const
    {
      return impulsive ? 1. : gamma / beta;
    }

    /// ∂(dv/dt)/∂w at the end of the step, 1/s.
    double acceleration_factor(const bool impulsive) const
    {
      return (impulsive ? 1. : (1. - alpha) / beta) / time_step;
    }

    /// What follows at the end of the step from @p w and the motion at its start.
    template <int dim>
    Motion<dim> end_of_step(const Tensor<1, dim> &w, const Motion<dim> &start, const bool impulsive) const
    {
      if (impulsive)
        return {w, (w - start.velocity) / time_step, start.algorithmic_acceleration};
      const Tensor<1, dim> &a_n = start.algorithmic_acceleration;
      const Tensor<1, dim> a    = (w - start.velocity) / (beta * time_step) - old_factor * a_n;
      return {start.velocity + time_step * ((1. - gamma) * a_n + gamma * a), (1. - alpha) * a + alpha * a_n,
              a};
    }

    /// (γ − 1) Δt, s, see MomentumAccount.
    double carried_time() const
    {
      return (gamma - 1.) * time_step;
    }

    /**
     * The force that goes with a as @p force at the end of the step goes with dv/dt, F̄ = (F − α F̄_n)/(1 − α). With
     * γ = 3/2, where a = (w − w_n)/Δt, it is the mean of the force from the middle of the last step to that of this one:
     * the sum of F̄ Δt is the change of momentum, without the overshoot of F after an impact.
     */
    template <int dim>
    Tensor<1, dim> mean_force(const Tensor<1, dim> &force, const Tensor<1, dim> &old_mean_force) const
    {
      return (force - alpha * old_mean_force) / (1. - alpha);
    }

  private:
    bool newmark         = true;
    double newmark_gamma = 1.5;
    bool is_first        = true;
    double time_step     = 0.;
    double alpha = 0., beta = 1., gamma = 1., old_factor = 0.;
  };
} // namespace Lahar

#endif
