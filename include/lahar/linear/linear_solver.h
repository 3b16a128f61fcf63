// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_linear_solver_h
#define lahar_linear_linear_solver_h

#include <lahar/linear/block_system.h>
#include <lahar/utilities/parameters.h>

#include <memory>

namespace Lahar
{
  /// How errors of the increments count: the norm of those of velocities and pressures, divided by these scales.
  struct IncrementScales
  {
    double velocity   = 1.; ///< m/s
    double pressure   = 1.; ///< Pa
    double negligible = 0.; ///< norms below this do no harm
  };

  /**
   * Solves the block system, at once or block by block.
   *
   * What belongs to the sparsity pattern is kept as long as the pattern stands, what was factorised as long as it is a
   * good approximation, but not beyond forget().
   */
  template <int dim>
  class LinearSolver
  {
  public:
    using Vector = typename BlockSystem<dim>::Vector;

    virtual ~LinearSolver() = default;

    /**
     * Solve the coupled system for the right-hand side of @p system.
     *
     * @return number of Krylov iterations, 1 for a direct solution.
     * @throws RunError if it fails.
     */
    virtual unsigned int solve(const BlockSystem<dim> &system, const IncrementScales &scales,
                               Vector &solution) = 0;

    /// Solve for one part alone, K x_0 = rhs_0 or S x_1 = rhs_1, S = H − C diag(K)⁻¹ Q. The other part stays as it is.
    virtual unsigned int solve_block(const BlockSystem<dim> &system, const unsigned int b,
                                     Vector &solution) = 0;

    /// Forget all earlier systems, so that what follows does not depend on them.
    virtual void forget() = 0;

    static void declare_parameters(Parameters &prm);
    static std::unique_ptr<LinearSolver> create(Parameters &prm);
  };
} // namespace Lahar

#endif
