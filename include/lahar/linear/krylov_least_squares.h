// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_krylov_least_squares_h
#define lahar_linear_krylov_least_squares_h

#include <deal.II/lac/vector.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * The problem that GMRES solves in its Krylov space (Saad & Schultz 1986): y with
   *
   *   ‖β e₁ − H y‖ → min,
   *
   * H the (k + 1) × k Hessenberg matrix of the space's orthonormal basis, reduced to a triangle R by Givens rotations as
   * its columns come.
   */
  class KrylovLeastSquares
  {
  public:
    /// @param first_residual β.
    explicit KrylovLeastSquares(const double first_residual);

    /// Add the next column of H: for the k-th one its k + 1 entries.
    void add_column(std::vector<double> column);

    unsigned int n_columns() const
    {
      return columns.size();
    }

    /// ‖β e₁ − H y‖.
    double residual() const;

    /// y.
    Vector<double> solution() const;

    /// min ‖H z‖ / ‖z‖: an error of y makes at least so much of it in the residual.
    double smallest_singular_value() const;

  private:
    std::vector<std::vector<double>> columns; ///< of R, down to the diagonal
    std::vector<double> cosines, sines;
    std::vector<double> rotated; ///< β e₁ after the rotations
  };
} // namespace Lahar

#endif
