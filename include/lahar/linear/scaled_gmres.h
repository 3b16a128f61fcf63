// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_scaled_gmres_h
#define lahar_linear_scaled_gmres_h

#include <lahar/linear/linear_solver.h>

#include <functional>

namespace Lahar
{
  /**
   * When GMRES ends, with residuals relative to the first one: at #tolerance, if the estimated error allows it too. If
   * #slack is positive, GMRES gives up after iteration k > 1 of n = #max_iterations with a residual above slack
   * tolerance^(k/n), and takes what is below that after the n-th.
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
   * The better P is, the better the residual estimates the error of the increments in the measure of the nonlinear
   * scheme. How good that is, the Krylov space tells: with σ the smallest singular value of its Hessenberg matrix an error
   * e there leaves a residual of at least σ|e|, so that residual/σ bounds what is hidden from it. GMRES ends at a residual
   * of the tolerance, or below IncrementScales::negligible and 0.3, once residual/σ is below a tenth of the solution or
   * ten times IncrementScales::negligible as well.
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
