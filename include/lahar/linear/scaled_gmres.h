#ifndef lahar_linear_scaled_gmres_h
#define lahar_linear_scaled_gmres_h

#include <lahar/linear/block_system.h>

#include <functional>

namespace Lahar
{
  /**
   * GMRES for the whole block system A x = b, preconditioned from the left by P⁻¹ ≈ A⁻¹, with velocity and pressure
   * divided by their scales D = diag(s_v, s_p): the system solved is
   *
   *   D⁻¹ P⁻¹ A D y = D⁻¹ P⁻¹ b,   x = D y.
   *
   * The preconditioned residual is an estimate of the error of the increments, in the measure of the nonlinear scheme:
   * the better, the better P is.
   *
   * @param apply_preconditioner sets its second argument to P⁻¹ times its first one.
   * @param tolerance of the residual of this system, relative to its right-hand side.
   * @return number of iterations, @p max_iterations + 1 if they did not suffice; then @p solution is of no use.
   */
  template <int dim>
  unsigned int solve_by_scaled_gmres(
    const BlockSystem<dim> &system,
    const std::function<void(const typename BlockSystem<dim>::Vector &, typename BlockSystem<dim>::Vector &)>
      &apply_preconditioner,
    const double velocity_scale, const double pressure_scale, const double tolerance,
    const unsigned int max_iterations, typename BlockSystem<dim>::Vector &solution);
} // namespace Lahar

#endif
