// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/lac/lapack_full_matrix.h>

#include <lahar/linear/krylov_least_squares.h>

#include <cmath>
#include <limits>

namespace Lahar
{
  KrylovLeastSquares::KrylovLeastSquares(const double first_residual)
    : rotated(1, first_residual)
  {}



  void KrylovLeastSquares::add_column(std::vector<double> column)
  {
    const unsigned int k = n_columns();
    AssertDimension(column.size(), k + 2);
    for (unsigned int i = 0; i < k; ++i)
    {
      const double upper = column[i], lower = column[i + 1];
      column[i]     = cosines[i] * upper + sines[i] * lower;
      column[i + 1] = -sines[i] * upper + cosines[i] * lower;
    }
    const double diagonal = std::hypot(column[k], column[k + 1]);
    cosines.push_back(diagonal > 0. ? column[k] / diagonal : 1.);
    sines.push_back(diagonal > 0. ? column[k + 1] / diagonal : 0.);
    column.pop_back();
    column[k] = diagonal;
    columns.push_back(column);
    rotated.push_back(-sines[k] * rotated[k]);
    rotated[k] *= cosines[k];
  }



  double KrylovLeastSquares::residual() const
  {
    return std::abs(rotated.back());
  }



  Vector<double> KrylovLeastSquares::solution() const
  {
    Vector<double> y(n_columns());
    for (unsigned int i = n_columns(); i-- > 0;)
    {
      double value = rotated[i];
      for (unsigned int j = i + 1; j < n_columns(); ++j)
        value -= columns[j][i] * y[j];
      y[i] = value / columns[i][i];
    }
    return y;
  }



  double KrylovLeastSquares::smallest_singular_value() const
  {
    if (columns.empty())
      return std::numeric_limits<double>::infinity();
    LAPACKFullMatrix<double> R(n_columns(), n_columns());
    for (unsigned int j = 0; j < n_columns(); ++j)
      for (unsigned int i = 0; i <= j; ++i)
        R(i, j) = columns[j][i];
    R.compute_svd();
    return R.singular_value(n_columns() - 1);
  }
} // namespace Lahar
