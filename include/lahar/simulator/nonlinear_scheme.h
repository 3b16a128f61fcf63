// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_nonlinear_scheme_h
#define lahar_simulator_nonlinear_scheme_h

#include <lahar/simulator/step_problem.h>

#include <functional>
#include <memory>

namespace Lahar
{
  /// What a nonlinear solution took.
  struct NonlinearReport
  {
    unsigned int iterations        = 0;
    unsigned int linear_iterations = 0;
    unsigned int n_held            = 0;     ///< vertices that were held, see StepProblem::end_iteration()
    double velocity_increment      = 0.;    ///< ‖δv‖/‖v‖ of the last iteration
    double pressure_increment      = 0.;    ///< ‖δp‖/‖p‖ of the last iteration
    double momentum_residual       = 0.;    ///< norm of the last assembled residual, N
    double mass_residual           = 0.;    ///< norm of the last assembled residual, m^dim/s
    bool is_settled                = false; ///< see StepProblem::is_settled()
    double yield_gap               = 0.;    ///< see StepProblem::yield_gap(), W (2D: W/m)
    double relative_yield_gap      = 0.;    ///< over the energy there
    std::vector<std::pair<double, double>> increments; ///< of velocity and pressure, by iteration
  };

  /**
   * Solves the nonlinear problem of a step until ‖δv‖/‖v‖ and ‖δp‖/‖p‖ are below the tolerance and friction is settled
   * (StepProblem::is_settled()), by Newton's method: all
   * derivatives are taken but for the viscosity's, which follows the chosen ViscosityLinearization. The derivatives of
   * the geometry are left out while they would flatten cells or turn the increment uphill, and a step that overshoots is
   * shortened by a line search; the work of the residual along the increment tells both.
   *
   * Where the yield stress is exact, its multipliers are updated after each full step as soon as the velocity increment is
   * small, and the iteration goes on until the relative yield gap is below its tolerance, too, or the fluid stands. Near
   * the yield limit the gap falls slowly: it is let pass where iterations run out.
   *
   * How the increments are found is what a scheme does of its own. It registers itself with
   * Factory<NonlinearScheme<dim>>; its entries stand in the subsection of its name in "Nonlinear solver".
   */
  template <int dim>
  class NonlinearScheme
  {
  public:
    virtual ~NonlinearScheme() = default;

    /// Declare the entries of all schemes.
    static void declare_parameters(Parameters &prm);

    /// The scheme that is chosen. @throws InputError
    static std::unique_ptr<NonlinearScheme> create(Parameters &prm);

    /// Read the entries that this scheme alone has.
    virtual void parse_parameters(Parameters & /*prm*/) {}

    /// @param before_iteration is called before each iteration; what it throws leaves the solution.
    /// @throws RunError if the iteration fails, with the number of the iteration and the reason.
    NonlinearReport solve(StepProblem<dim> &problem, const std::function<void()> &before_iteration);

    unsigned int max_iterations() const
    {
      return maximum_iterations;
    }

  protected:
    /// Solve the assembled system for the increments. @return linear iterations.
    virtual unsigned int find_increments(StepProblem<dim> &problem) const = 0;

    /// Relative error of the increments that the iteration does not notice.
    double negligible_error() const;

  private:
    /// One iteration: assemble, solve, step. Enters in the report what it took.
    void iterate(StepProblem<dim> &problem, NonlinearReport &report);

    /// Whether both increments are within the tolerance.
    bool are_increments_small(const NonlinearReport &report) const
    {
      return report.velocity_increment <= tolerance && report.pressure_increment <= tolerance &&
             report.is_settled;
    }

    /// Whether in addition the gap of an exact yield stress is within its own.
    bool is_converged(const StepProblem<dim> &problem, const NonlinearReport &report) const
    {
      return are_increments_small(report) &&
             (!problem.fluids().any_exact_yield_stress() || problem.is_standing() ||
              report.relative_yield_gap <= gap_tolerance || report.iterations == maximum_iterations);
    }

    /// Enter the gap in the report.
    static void find_yield_gap(const StepProblem<dim> &problem, NonlinearReport &report);

    /// The chosen linearisation of the viscosity, Newton's for a fluid without yield stress.
    ViscosityLinearization viscosity_linearization(const StepProblem<dim> &problem) const;

    ViscosityLinearization viscosity = ViscosityLinearization::primal_dual;
    double tolerance                 = 1e-4;
    unsigned int maximum_iterations  = 30;
    double multiplier_increment      = 0.1; ///< velocity increment below which multipliers are updated
    double gap_tolerance             = 1e-3;
    bool multipliers_follow          = false; ///< whether they are updated already in this step
    bool motion             = true; ///< whether the Jacobian has the derivatives of the geometry in this step
    double motion_increment = 0.;   ///< velocity increment below which they come back
  };
} // namespace Lahar

#endif
