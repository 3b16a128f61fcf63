#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_gmres.h>

#include <lahar/linear/scaled_gmres.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// A solution whose residual has not become smaller than this part of the first one is none.
    constexpr double largest_reduction = 0.3;

    /// Ends GMRES as GmresTargets says.
    class Control : public SolverControl
    {
    public:
      Control(const GmresTargets &targets, const double first_residual, const double negligible)
        : SolverControl(targets.max_iterations,
                        std::max(targets.tolerance * first_residual,
                                 std::min(negligible, largest_reduction * first_residual)),
                        false, false)
        , slack(targets.slack)
        , first_residual(first_residual)
      {}

      State check(const unsigned int step, const double residual) override
      {
        const State state = SolverControl::check(step, residual);
        if (slack == 0. || step < 2 || state == success)
          return state;
        const double part_done = static_cast<double>(step) / max_steps();
        if (!(residual <=
              slack * std::pow(tolerance() / first_residual, part_done) * first_residual)) // or NaN
          return failure;
        return step >= max_steps() ? success : iterate;
      }

    private:
      const double slack, first_residual;
    };

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
    const IncrementScales &scales, const GmresTargets &targets, typename BlockSystem<dim>::Vector &solution)
  {
    using Vector     = typename BlockSystem<dim>::Vector;
    const auto scale = [&](Vector &vector, const double power) {
      vector.block(0) *= std::pow(scales.velocity, power);
      vector.block(1) *= std::pow(scales.pressure, power);
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
    Control control(targets, norm, scales.negligible);
    SolverGMRES<Vector> gmres(control,
                              typename SolverGMRES<Vector>::AdditionalData(targets.max_iterations + 2));
    solution = 0.;
    try
    {
      if (norm != 0.) // a NaN fails in GMRES
        gmres.solve(matrix, solution, right_hand_side, PreconditionIdentity());
    }
    catch (const SolverControl::NoConvergence &)
    {
      return targets.max_iterations + 1;
    }
    scale(solution, 1.);
    return control.last_step();
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
