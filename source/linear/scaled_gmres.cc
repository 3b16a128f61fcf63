// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/krylov_least_squares.h>
#include <lahar/linear/scaled_gmres.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// A solution whose residual has not become smaller than this part of the first one is none.
    constexpr double largest_reduction = 0.3;
    /// The estimated error may be this part of the solution, or this multiple of IncrementScales::negligible.
    constexpr double largest_error = 0.1, error_per_negligible = 10.;

    enum class State
    {
      iterate,
      success,
      failure
    };

    State check(const KrylovLeastSquares &problem, const GmresTargets &targets, const double first_residual,
                const double negligible)
    {
      const unsigned int k  = problem.n_columns();
      const double target   = std::max(targets.tolerance * first_residual,
                                       std::min(negligible, largest_reduction * first_residual)),
                   residual = problem.residual();
      if (residual <= target && residual <= problem.smallest_singular_value() *
                                              std::max(largest_error * problem.solution().l2_norm(),
                                                       error_per_negligible * negligible))
        return State::success;
      if (targets.slack > 0. && k > 1)
      {
        const double part_done = static_cast<double>(k) / targets.max_iterations;
        if (!(residual <= targets.slack * std::pow(target / first_residual, part_done) * first_residual))
          return State::failure;
        if (k >= targets.max_iterations)
          return State::success;
      }
      return k < targets.max_iterations && std::isfinite(residual) ? State::iterate : State::failure;
    }
  } // namespace



  template <int dim>
  unsigned int solve_by_scaled_gmres(
    const BlockSystem<dim> &system,
    const std::function<void(const typename BlockSystem<dim>::Vector &, typename BlockSystem<dim>::Vector &)>
      &apply_preconditioner,
    const IncrementScales &scales, const GmresTargets &targets, typename BlockSystem<dim>::Vector &solution)
  {
    using Vector     = typename BlockSystem<dim>::Vector;
    const auto scale = [&](Vector &vector, const double power) {
      vector.block(0) *= std::pow(scales.velocity, power);
      vector.block(1) *= std::pow(scales.pressure, power);
    };

    solution = 0.;
    std::vector<Vector> basis(1, solution);
    apply_preconditioner(system.right_hand_side(), basis[0]);
    scale(basis[0], -1.);
    double norm = basis[0].l2_norm();
    if (norm == 0.)
      return 0;

    const double first_residual = norm;
    KrylovLeastSquares problem(first_residual);
    Vector scaled(solution), product(solution);
    State state = State::iterate;
    for (; state == State::iterate; state = check(problem, targets, first_residual, scales.negligible))
    {
      if (!(norm > 0.)) // the space is exhausted, or a NaN
        return targets.max_iterations + 1;
      basis.back() /= norm;
      scaled = basis.back();
      scale(scaled, 1.);
      system.matrix().vmult(product, scaled);
      Vector next(solution);
      apply_preconditioner(product, next);
      scale(next, -1.);
      // Modified Gram–Schmidt is stable enough for GMRES (Paige, Rozložník & Strakoš 2006).
      std::vector<double> column;
      for (const Vector &previous : basis)
      {
        column.push_back(next * previous);
        next.add(-column.back(), previous);
      }
      norm = next.l2_norm();
      column.push_back(norm);
      problem.add_column(column);
      basis.push_back(std::move(next));
    }
    if (state == State::failure)
      return targets.max_iterations + 1;

    const dealii::Vector<double> y = problem.solution();
    for (unsigned int i = 0; i < problem.n_columns(); ++i)
      solution.add(y[i], basis[i]);
    scale(solution, 1.);
    return problem.n_columns();
  }



  template unsigned int solve_by_scaled_gmres<2>(
    const BlockSystem<2> &,
    const std::function<void(const BlockSystem<2>::Vector &, BlockSystem<2>::Vector &)> &,
    const IncrementScales &, const GmresTargets &, BlockSystem<2>::Vector &);
  template unsigned int solve_by_scaled_gmres<3>(
    const BlockSystem<3> &,
    const std::function<void(const BlockSystem<3>::Vector &, BlockSystem<3>::Vector &)> &,
    const IncrementScales &, const GmresTargets &, BlockSystem<3>::Vector &);
} // namespace Lahar
