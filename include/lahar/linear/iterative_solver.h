// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_iterative_solver_h
#define lahar_linear_iterative_solver_h

#include <deal.II/lac/trilinos_precondition.h>

#include <lahar/linear/linear_solver.h>

namespace Lahar
{
  /**
   * GMRES, for the whole system with the block-triangular preconditioner
   *
   *   P = [ K̃  0 ]     K̃ ≈ K,   S̃ ≈ S = H − C diag(K)⁻¹ Q,
   *       [ C  S̃ ]
   *
   * for one block with K̃ or S̃. K̃⁻¹ and S̃⁻¹ are a cycle of algebraic multigrid (ML, smoothed aggregation of nodes,
   * Chebyshev smoothers) or incomplete factors (Ifpack, ILU). The modes that multigrid keeps are the translations, with
   * solids the rotations too: without them it does not see how soft a slender solid is in bending. In a fluid alone they
   * cost more than they save.
   *
   * K̃ and S̃ serve for the next systems of the same pattern too, until GMRES takes half as many iterations again as with
   * a fresh one. Where it fails with fresh multigrid, S̃⁻¹ is incomplete factors for this system and the next ones of
   * this pattern: in sprays and thin films particles of little mass tie the pressures around them together in a way
   * that aggregates do not follow.
   *
   * Why diag(K) will do where plugs make it differ much from K: were C = −Qᵀ, the Schur complement H − C K⁻¹ Q would
   * lie between H and H − C M⁻¹ Q, M the inertia in K, and the stabilisation H is about as large as the second term,
   * because its parameter is about Δt/(2ρ).
   */
  template <int dim>
  class IterativeSolver : public LinearSolver<dim>
  {
  public:
    using Vector      = typename LinearSolver<dim>::Vector;
    using BlockVector = typename LinearSolver<dim>::BlockVector;

    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm) override;

    unsigned int solve(const BlockSystem<dim> &system, const IncrementScales &scales,
                       Vector &solution) override;

    void start_blocks(const BlockSystem<dim> &system) override;

    void solve_block(const unsigned int b, const BlockVector &right_hand_side,
                     BlockVector &solution) override;

    void forget() override;

  private:
    using Matrix         = TrilinosWrappers::SparseMatrix;
    using Preconditioner = std::unique_ptr<TrilinosWrappers::PreconditionBase>;

    /// K̃⁻¹ or S̃⁻¹ for a matrix with @p n_components unknowns a node, dim or 1; by multigrid or incomplete factors.
    Preconditioner make_preconditioner(const Matrix &matrix, const unsigned int n_components,
                                       const BlockSystem<dim> &system, const bool by_multigrid) const;

    /// What approximates the inverse of one system: K̃⁻¹ and S̃⁻¹, and the matrices that they refer to.
    struct ApproximateInverse
    {
      unsigned int pattern            = 0; ///< BlockSystem::pattern_number()
      unsigned int n_fresh_iterations = 0; ///< of the system that it was made from
      bool schur_by_multigrid         = true;
      bool worn                       = false;
      bool multigrid_failed           = false; ///< for S̃ of this pattern
      Matrix K, S;
      Preconditioner inverse_K, inverse_S;
    };

    void make_inverse(const BlockSystem<dim> &system, const bool schur_by_multigrid);

    std::unique_ptr<ApproximateInverse> inverse;

    bool multigrid              = true;
    double tolerance            = 1e-3;
    unsigned int max_iterations = 200;
  };
} // namespace Lahar

#endif
