#ifndef lahar_linear_scaled_gmres_h
#define lahar_linear_scaled_gmres_h

#include <lahar/linear/linear_solver.h>

#include <functional>

namespace Lahar
{
  /**
   * When GMRES ends, with residuals relative to the first one: at #tolerance. If #slack is positive, GMRES gives up
   * after iteration k > 1 of n = #max_iterations with a residual above slack tolerance^(k/n), and takes what is below
   * that after the n-th.
   */
  struct GmresTargets
  {
    unsigned int max_iterations;
    double tolerance;
    double slack = 0.;
  };

  /**
   * GMRES for the whole block system A x = b, preconditioned from the left by P⁻¹ ≈ A⁻¹, with velocity and pressure
   * divided by their scales D = diag(s_v, s_p): the system solved is
   *
   *   D⁻¹ P⁻¹ A D y = D⁻¹ P⁻¹ b,   x = D y.
   *
   * The preconditioned residual is an estimate of the error of the increments, in the measure of the nonlinear scheme:
   * the better, the better P is.
   *
   * Where it has fallen below IncrementScales::negligible and to 0.3 of its first value, the solution is good enough.
   *
   * @param apply_preconditioner sets its second argument to P⁻¹ times its first one.
   * @return number of iterations, max_iterations + 1 if they did not suffice; then @p solution is of no use.
   */
  template <int dim>
  unsigned int solve_by_scaled_gmres(
    const BlockSystem<dim> &system,
    const std::function<void(const typename BlockSystem<dim>::Vector &, typename BlockSystem<dim>::Vector &)>
      &apply_preconditioner,
    const IncrementScales &scales, const GmresTargets &targets, typename BlockSystem<dim>::Vector &solution);
} // namespace Lahar

#endif
