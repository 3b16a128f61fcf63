#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <lahar/linear/scaled_gmres.h>

namespace Lahar
{
  namespace
  {
    /// D⁻¹ P⁻¹ A D: what GMRES sees.
    template <typename Vector>
    struct PreconditionedOperator
    {
      std::function<void(Vector &, const Vector &)> apply;

      void vmult(Vector &y, const Vector &x) const
      {
        apply(y, x);
      }
    };
  } // namespace



  template <int dim>
  unsigned int solve_by_scaled_gmres(
    const BlockSystem<dim> &system,
    const std::function<void(const typename BlockSystem<dim>::Vector &, typename BlockSystem<dim>::Vector &)>
      &apply_preconditioner,
    const double velocity_scale, const double pressure_scale, const double tolerance,
    const unsigned int max_iterations, typename BlockSystem<dim>::Vector &solution)
  {
    using Vector     = typename BlockSystem<dim>::Vector;
    const auto scale = [&](Vector &vector, const double power) {
      vector.block(0) *= std::pow(velocity_scale, power);
      vector.block(1) *= std::pow(pressure_scale, power);
    };

    Vector scaled(solution), product(solution);
    const PreconditionedOperator<Vector> matrix{[&](Vector &y, const Vector &x) {
      scaled = x;
      scale(scaled, 1.);
      system.matrix().vmult(product, scaled);
      apply_preconditioner(product, y);
      scale(y, -1.);
    }};

    Vector right_hand_side(solution);
    apply_preconditioner(system.right_hand_side(), right_hand_side);
    scale(right_hand_side, -1.);

    const double norm = right_hand_side.l2_norm();
    SolverControl control(max_iterations, tolerance * norm, false, false);
    SolverGMRES<Vector> gmres(control, typename SolverGMRES<Vector>::AdditionalData(max_iterations + 2));
    solution = 0.;
    try
    {
      if (norm != 0.) // a NaN fails in GMRES
        gmres.solve(matrix, solution, right_hand_side, PreconditionIdentity());
    }
    catch (const SolverControl::NoConvergence &)
    {
      return max_iterations + 1;
    }
    scale(solution, 1.);
    return control.last_step();
  }



  template unsigned int solve_by_scaled_gmres<2>(
    const BlockSystem<2> &,
    const std::function<void(const BlockSystem<2>::Vector &, BlockSystem<2>::Vector &)> &, const double,
    const double, const double, const unsigned int, BlockSystem<2>::Vector &);
  template unsigned int solve_by_scaled_gmres<3>(
    const BlockSystem<3> &,
    const std::function<void(const BlockSystem<3>::Vector &, BlockSystem<3>::Vector &)> &, const double,
    const double, const double, const unsigned int, BlockSystem<3>::Vector &);
} // namespace Lahar
