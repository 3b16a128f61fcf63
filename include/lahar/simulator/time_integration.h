// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_time_integration_h
#define lahar_simulator_time_integration_h

#include <deal.II/base/tensor.h>

#include <lahar/simulator/time_rule.h>

#include <memory>

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
   * it. All forces are those at the end of the step. The rules, of which "Time integration" names one, are
   * TimeCoefficients in the same formulas.
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

    /// Begin a step of length @p time_step (s); @p is_first whether it is a run's first one.
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
      return impulsive ? 1. : coefficients.gamma / coefficients.beta;
    }

    /// ∂(dv/dt)/∂w at the end of the step, 1/s.
    double acceleration_factor(const bool impulsive) const
    {
      return (impulsive ? 1. : (1. - coefficients.alpha) / coefficients.beta) / time_step;
    }

    /// What follows at the end of the step from @p w and the motion at its start.
    template <int dim>
    Motion<dim> end_of_step(const Tensor<1, dim> &w, const Motion<dim> &start, const bool impulsive) const
    {
      if (impulsive)
        return {w, (w - start.velocity) / time_step, start.algorithmic_acceleration};
      const Tensor<1, dim> &a_n = start.algorithmic_acceleration;
      const Tensor<1, dim> a    = (w - start.velocity) / (coefficients.beta * time_step) -
                               coefficients.old_factor * a_n;
      return {start.velocity + time_step * ((1. - coefficients.gamma) * a_n + coefficients.gamma * a),
              (1. - coefficients.alpha) * a + coefficients.alpha * a_n, a};
    }

    /// (γ − 1) Δt, s, see MomentumAccount.
    double carried_time() const
    {
      return (coefficients.gamma - 1.) * time_step;
    }

    /**
     * The force that goes with a as @p force at the end of the step goes with dv/dt, F̄ = (F − α F̄_n)/(1 − α). With
     * γ = 3/2, where a = (w − w_n)/Δt, it is the mean of the force from the middle of the last step to that of this one:
     * the sum of F̄ Δt is the change of momentum, without the overshoot of F after an impact.
     */
    template <int dim>
    Tensor<1, dim> mean_force(const Tensor<1, dim> &force, const Tensor<1, dim> &old_mean_force) const
    {
      return (force - coefficients.alpha * old_mean_force) / (1. - coefficients.alpha);
    }

    /// −α Δt, s: what forces F have given by the end of the step lies this times the last F̄ below the sum of F Δt.
    double force_lag() const
    {
      return -coefficients.alpha * time_step;
    }

  private:
    std::shared_ptr<const TimeRule> rule;
    double newmark_gamma = 1.5;
    bool is_first        = true;
    double time_step     = 0.;
    TimeCoefficients coefficients;
  };
} // namespace Lahar

#endif
