#ifndef lahar_simulator_time_integration_h
#define lahar_simulator_time_integration_h

#include <lahar/assembly/fluid_cell.h>
#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * One-step rules with the velocity as unknown.
   *
   * Newmark (β = 1/4, γ = 1/2):  a = 2/Δt (v − v_n) − a_n,  x = x_n + Δt/2 (v_n + v): second order, undamped.
   * Backward Euler:              a = (v − v_n)/Δt,          x = x_n + Δt v:           first order, damped.
   *
   * Newmark's first step of a run is one of backward Euler, because the acceleration at rest does not obey
   * incompressibility and the trapezoidal rule would carry that error along for ever.
   */
  class TimeIntegration
  {
  public:
    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// Begin a step of length @p time_step (s); @p is_first as said above.
    void start_step(const double time_step, const bool is_first);

    StepFactors factors() const;

    template <int dim>
    Tensor<1, dim> acceleration(const Tensor<1, dim> &velocity, const Tensor<1, dim> &old_velocity,
                                const Tensor<1, dim> &old_acceleration) const
    {
      return factors().acceleration_factor * (velocity - old_velocity) -
             (trapezoidal ? 1. : 0.) * old_acceleration;
    }

    template <int dim>
    Tensor<1, dim> displacement(const Tensor<1, dim> &velocity, const Tensor<1, dim> &old_velocity) const
    {
      return trapezoidal ? 0.5 * time_step * (old_velocity + velocity) : time_step * velocity;
    }

  private:
    bool newmark     = true;
    bool trapezoidal = true;
    double time_step = 0.;
  };
} // namespace Lahar

#endif
