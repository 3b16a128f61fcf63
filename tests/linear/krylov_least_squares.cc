// SPDX-License-Identifier: GPL-3.0-or-later

// Test the least-squares problem of GMRES, column by column, on a random Hessenberg matrix: the solution has a residual
// orthogonal to the columns, of the norm told; the smallest singular value is that of the normal equations.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <lahar/linear/krylov_least_squares.h>

#include "tests.h"

using namespace Tests;

int main()
{
  const unsigned int n = 6;
  const double beta    = 3.;
  Random random;
  FullMatrix<double> H(n + 1, n);
  KrylovLeastSquares problem(beta);
  check("without columns the residual is the first one", problem.residual() - beta, 0.);

  double worst_gradient = 0., worst_residual = 0., worst_singular_value = 0., last_residual = beta;
  bool descends = true;
  for (unsigned int k = 1; k <= n; ++k)
  {
    std::vector<double> column(k + 1);
    for (unsigned int i = 0; i <= k; ++i)
      column[i] = H(i, k - 1) = random.number();
    problem.add_column(column);

    // r = β e₁ − H y.
    const Vector<double> y = problem.solution();
    Vector<double> residual(k + 1);
    residual[0] = beta;
    for (unsigned int i = 0; i <= k; ++i)
      for (unsigned int j = 0; j < k; ++j)
        residual[i] -= H(i, j) * y[j];
    LAPACKFullMatrix<double> normal(k, k);
    for (unsigned int i = 0; i < k; ++i)
    {
      double gradient = 0.;
      for (unsigned int l = 0; l <= k; ++l)
        gradient += H(l, i) * residual[l];
      worst_gradient = std::max(worst_gradient, std::abs(gradient));
      for (unsigned int j = 0; j < k; ++j)
        for (unsigned int l = 0; l <= k; ++l)
          normal(i, j) += H(l, i) * H(l, j);
    }
    normal.compute_eigenvalues();
    double smallest = 1e100;
    for (unsigned int i = 0; i < k; ++i)
      smallest = std::min(smallest, normal.eigenvalue(i).real());
    worst_residual       = std::max(worst_residual, std::abs(problem.residual() - residual.l2_norm()));
    worst_singular_value = std::max(worst_singular_value,
                                    std::abs(problem.smallest_singular_value() - std::sqrt(smallest)));
    descends             = descends && problem.residual() <= last_residual;
    last_residual        = problem.residual();
  }
  check("number of columns", problem.n_columns() == n);
  check("solution", worst_gradient, 1e-12);
  check("norm of its residual", worst_residual, 1e-12);
  check("which more columns do not raise", descends);
  check("smallest singular value", worst_singular_value, 1e-10);

  // A column of zeros: a direction that the matrix does not know.
  KrylovLeastSquares singular(1.);
  singular.add_column({2., 1.});
  singular.add_column({0., 0., 0.});
  check("singular value of a singular problem", singular.smallest_singular_value(), 1e-15);
  return n_failed;
}
