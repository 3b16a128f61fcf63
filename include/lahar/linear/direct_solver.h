// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_direct_solver_h
#define lahar_linear_direct_solver_h

#include <Amesos_BaseSolver.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>

#include <lahar/linear/linear_solver.h>

#include <array>
#include <string>

namespace Lahar
{
  /**
   * Sparse factorisation (Amesos: MUMPS or KLU) of the whole system, the unknowns of a node side by side, or of K and S.
   *
   * A factorisation serves as long as it is a good preconditioner: the next systems of the same pattern are solved by
   * GMRES, preconditioned from the left by the last factorisation, unless that takes or, by its convergence, would take
   * more than a few iterations; then the matrix at hand is factorised. The tolerance is measured in the preconditioned
   * residual, with velocity and pressure divided by their scales: it bounds the relative error of the increments that
   * the nonlinear scheme checks.
   */
  template <int dim>
  class DirectSolver : public LinearSolver<dim>
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
    /// A matrix with its factorisation.
    struct Factorization
    {
      std::unique_ptr<Epetra_CrsMatrix> matrix;
      std::unique_ptr<Epetra_MultiVector> solution, right_hand_side;
      Epetra_LinearProblem problem;
      std::unique_ptr<Amesos_BaseSolver> solver;
      unsigned int pattern = 0;

      /// Take over a matrix of new pattern and analyse it.
      void analyse(std::unique_ptr<Epetra_CrsMatrix> matrix, const std::string &package,
                   const unsigned int pattern);
      void factorize();
      void apply();
      /**
       * Check what the package did last; not each failure of MUMPS reaches Amesos' return value @p status. Collective.
       * @throws RunError with the sentence @p what and the package's reason behind it; std::runtime_error if there is
       * not enough memory, since no shorter step needs less.
       */
      void check(const int status, const std::string &what) const;
    };

    void factorize_whole(const BlockSystem<dim> &system);
    void apply_whole(const Vector &right_hand_side, Vector &solution);

    std::string package         = "Amesos_Mumps";
    double tolerance            = 1e-2;
    unsigned int max_iterations = 6;
    Factorization whole;
    std::array<Factorization, 2> blocks; ///< of K and S
  };
} // namespace Lahar

#endif
