// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_time_integration_h
#define lahar_simulator_time_integration_h

#include <lahar/assembly/fluid_cell.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * One-step rules with the velocity as unknown.
   *
   * Newmark:         a = (v − v_n)/(γ Δt) − (1−γ)/γ a_n,  x = x_n + Δt/2 (v_n + v), that is β = γ/2.
   * Backward Euler:  a = (v − v_n)/Δt,                    x = x_n + Δt v.
   *
   * γ = 1/2 is the trapezoidal rule of Franci & Zhang (2018). Incompressibility makes a differential-algebraic system
   * of index two, in which the rule multiplies what remeshing and impacts leave in div a by −(1−γ)/γ in every step:
   * with γ = 1/2 it never dies away and in the end destroys the flow. The trapezoidal displacement keeps volume to
   * second order whatever γ is, provided that v_n is free of divergence. Where a cell has only just become fluid,
   * because the fluid lands on a wall or on itself, v_n is not: it closes the gap. The vertices of such a cell move by
   * Δt v in that one step, as in backward Euler. The first step of a run has γ = 1, because the acceleration at rest
   * does not obey incompressibility.
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

    StepFactors factors() const;

    /// a at the end of the step.
    template <int dim>
    Tensor<1, dim> acceleration(const Tensor<1, dim> &velocity, const Tensor<1, dim> &old_velocity,
                                const Tensor<1, dim> &old_acceleration) const
    {
      return 1. / (gamma * time_step) * (velocity - old_velocity) - (1. - gamma) / gamma * old_acceleration;
    }

    /// ∂x/∂v at the end of the step, s. @param arrives whether the particle is a corner of a cell that becomes fluid.
    double position_factor(const bool arrives) const
    {
      return newmark && !arrives ? 0.5 * time_step : time_step;
    }

    /// x − x_n at the end of the step: s v + (Δt − s) v_n, s the position factor.
    template <int dim>
    Tensor<1, dim> displacement(const Tensor<1, dim> &velocity, const Tensor<1, dim> &old_velocity,
                                const double position_factor) const
    {
      return position_factor * velocity + (time_step - position_factor) * old_velocity;
    }

  private:
    bool newmark         = true;
    double newmark_gamma = 0.7;
    double gamma         = 1.;
    double time_step     = 0.;
    bool is_first        = true;
  };
} // namespace Lahar

#endif
