// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/krylov_least_squares.h>

#include <Eigen/SVD>

#include <cmath>
#include <limits>

namespace Lahar
{
  namespace
  {
    /// R from its columns, each down to the diagonal.
    Eigen::MatrixXd upper_triangle(const std::vector<std::vector<double>> &columns)
    {
      const Eigen::Index n = columns.size();
      Eigen::MatrixXd R    = Eigen::MatrixXd::Zero(n, n);
      for (Eigen::Index j = 0; j < n; ++j)
        R.col(j).head(j + 1) = Eigen::Map<const Eigen::VectorXd>(columns[j].data(), j + 1);
      return R;
    }
  } // namespace



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
    const Eigen::Map<const Eigen::VectorXd> right_side(rotated.data(), n_columns());
    const Eigen::VectorXd y = upper_triangle(columns).triangularView<Eigen::Upper>().solve(right_side);
    return Vector<double>(y.begin(), y.end());
  }



  double KrylovLeastSquares::smallest_singular_value() const
  {
    if (columns.empty())
      return std::numeric_limits<double>::infinity();
    return Eigen::BDCSVD<Eigen::MatrixXd>(upper_triangle(columns)).singularValues().minCoeff();
  }
} // namespace Lahar
