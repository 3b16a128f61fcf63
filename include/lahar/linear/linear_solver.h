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
    double velocity   = 1.;    ///< m/s
    double pressure   = 1.;    ///< Pa
    double negligible = 0.;    ///< norms below this do no harm
    bool are_coarse   = false; ///< the iteration of which they are gains no more than a digit each time
  };

  /**
   * Solves the block system, at once or in two steps.
   *
   * What belongs to the sparsity pattern is kept as long as the pattern stands, what was factorised as long as it is a
   * good approximation, but not beyond forget().
   *
   * A solver registers itself with Factory<LinearSolver<dim>>; its entries stand in a subsection of "Linear solver".
   */
  template <int dim>
  class LinearSolver
  {
  public:
    using Vector      = typename BlockSystem<dim>::Vector;
    using BlockVector = TrilinosWrappers::MPI::Vector;

    virtual ~LinearSolver() = default;

    /**
     * Solve the coupled system for the right-hand side of @p system.
     *
     * @return number of Krylov iterations, 1 for a direct solution.
     * @throws RunError if it fails.
     */
    virtual unsigned int solve(const BlockSystem<dim> &system, const IncrementScales &scales,
                               Vector &solution) = 0;

    /**
     * The same without a system of velocities and pressures together. A sweep solves for the velocities, with the
     * pressures as they are, and then for the pressures,
     *
     *   K δx_0 = r_0,   S δx_1 = r_1 − C δx_0,   S = H − C diag(K)⁻¹ Q,   r the residual of the system,
     *
     * and GMRES makes the best of the sweeps: they are its preconditioner, see solve_by_scaled_gmres(). K and S are those
     * of an earlier system of the same pattern as long as few sweeps suffice with them.
     *
     * @return number of sweeps.
     * @throws RunError if they do not converge.
     */
    unsigned int solve_in_two_steps(const BlockSystem<dim> &system, const IncrementScales &scales,
                                    Vector &solution);

    /// Take K and S from @p system as it is now.
    virtual void start_blocks(const BlockSystem<dim> &system) = 0;

    /// Solve K x = @p right_hand_side (@p b = 0) or S x = @p right_hand_side (1) with K and S of start_blocks().
    virtual void solve_block(const unsigned int b, const BlockVector &right_hand_side,
                             BlockVector &solution) = 0;

    /// Forget all earlier systems, so that what follows does not depend on them.
    virtual void forget();

    /// Declare the entries of all solvers.
    static void declare_parameters(Parameters &prm);

    /// The solver that is chosen. The entries of the others are checked, too. @throws InputError
    static std::unique_ptr<LinearSolver> create(Parameters &prm);

    /// Read the entries of this solver.
    virtual void parse_parameters(Parameters & /*prm*/) {}

  private:
    unsigned int blocks_pattern = 0; ///< of the system that K and S are of, 0 if there is none
  };
} // namespace Lahar

#endif
