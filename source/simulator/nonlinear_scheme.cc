// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/nonlinear_scheme.h>
#include <lahar/utilities/factory.h>

#include <limits>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Weight of the plastic part's derivative after a step that overshot.
    constexpr double overshoot_weight = 0.7;

    // Without the derivatives of the geometry the iteration is robust but slow: below an increment they come back, a ten
    // times smaller one each time that they had to be left out again.
    constexpr double largest_motion_increment = 0.2;
    constexpr double motion_increment_factor  = 0.1;

    /// A full step overshoots if the work along the increment at its end exceeds this part of that at its start.
    constexpr double overshoot           = 0.1;
    constexpr double shortest_search     = 0.2;
    constexpr unsigned int n_trial_steps = 3;

    /// Where multipliers that are updated in every iteration go to and fro, they wait after this number of iterations until
    /// the increments are within the tolerance.
    constexpr unsigned int n_eager_iterations = 15;

    /// Increments are solved for to this part of the tolerance of the nonlinear iteration.
    constexpr double negligible_part = 0.1;
  } // namespace



  template <int dim>
  void NonlinearScheme<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Nonlinear solver");
    Factory<NonlinearScheme>::declare_choice(prm, "Scheme", "coupled",
                                             "How Newton's method finds its increments.");
    Factory<NonlinearScheme>::declare_parameters(prm);
    prm.declare_choice(
      "Viscosity linearization", "primal-dual", "picard|newton|primal-dual",
      "Derivative of the viscosity in the Jacobian: 'picard' (none), 'newton' (consistent; fails for a "
      "large regularization parameter) or 'primal-dual'.");
    prm.declare_positive(
      "Tolerance", "1e-4",
      "Largest relative increment of velocity and pressure in the last iteration, above 0 and below 1.");
    prm.declare_positive(
      "Multiplier increment", "0.1",
      "Relative increment of velocity, above 0, from which on the multipliers of an exact yield stress are updated.");
    prm.declare_positive(
      "Gap tolerance", "1e-3",
      "Largest yield gap G/E of an exact yield stress in the last iteration, above 0, unless the fluid stands or "
      "iterations run out.");
    prm.declare_count("Maximum iterations", "30", "A step that needs more iterations has failed, 1 to 1000.",
                      1, 1000);
    prm.leave_subsection();
  }



  template <int dim>
  std::unique_ptr<NonlinearScheme<dim>> NonlinearScheme<dim>::create(Parameters &prm)
  {
    prm.enter_subsection("Nonlinear solver");
    auto scheme = Factory<NonlinearScheme>::create(Factory<NonlinearScheme>::choice(prm, "Scheme"), prm);

    const std::string viscosity = prm.get("Viscosity linearization");
    if (viscosity == "picard")
      scheme->viscosity = ViscosityLinearization::picard;
    else if (viscosity == "newton")
      scheme->viscosity = ViscosityLinearization::newton;
    else if (viscosity == "primal-dual")
      scheme->viscosity = ViscosityLinearization::primal_dual;
    else
      prm.throw_wrong_value("Viscosity linearization", "picard|newton|primal-dual");

    scheme->tolerance = prm.get_positive("Tolerance");
    if (scheme->tolerance >= 1.)
      prm.throw_wrong_value("Tolerance", "a number above 0 and below 1");
    scheme->multiplier_increment = prm.get_positive("Multiplier increment");
    scheme->gap_tolerance        = prm.get_positive("Gap tolerance");
    scheme->maximum_iterations   = prm.get_count("Maximum iterations", 1, 1000);
    prm.leave_subsection();
    return scheme;
  }



  template <int dim>
  ViscosityLinearization NonlinearScheme<dim>::viscosity_linearization(const StepProblem<dim> &problem) const
  {
    return viscosity == ViscosityLinearization::primal_dual && !problem.fluids().any_yields()
             ? ViscosityLinearization::newton
             : viscosity;
  }



  template <int dim>
  double NonlinearScheme<dim>::negligible_error() const
  {
    return negligible_part * tolerance;
  }



  template <int dim>
  NonlinearReport NonlinearScheme<dim>::solve(StepProblem<dim> &problem,
                                              const std::function<void()> &before_iteration)
  {
    NonlinearReport report;
    try
    {
      do
      {
        before_iteration();
        ++report.iterations;
        iterate(problem, report);
        report.increments.emplace_back(report.velocity_increment, report.pressure_increment);
      } while (!is_converged(problem, report) && report.iterations < maximum_iterations);
      if (!is_converged(problem, report))
      {
        std::ostringstream reason;
        reason << "no convergence, the relative increments are " << report.velocity_increment
               << " (velocity) and " << report.pressure_increment << " (pressure), largest at ("
               << problem.place_of_largest_increment() << ") m, the tolerance is " << tolerance
               << (report.is_settled ? ""
                                     : "; sliding with friction turns round from iteration to iteration");
        throw RunError(reason.str());
      }
      report.n_held = problem.n_held();
      if (problem.fluids().any_exact_yield_stress())
        problem.update_multipliers();
      else if (problem.fluids().any_yields())
        find_yield_gap(problem, report);
    }
    catch (const RunError &error)
    {
      throw RunError("iteration " + std::to_string(report.iterations) + ": " + error.what());
    }
    return report;
  }



  template <int dim>
  void NonlinearScheme<dim>::find_yield_gap(const StepProblem<dim> &problem, NonlinearReport &report)
  {
    const auto [gap, energy]  = problem.yield_gap();
    report.yield_gap          = gap;
    report.relative_yield_gap = gap / std::max(energy, std::numeric_limits<double>::min());
  }



  template <int dim>
  void NonlinearScheme<dim>::iterate(StepProblem<dim> &problem, NonlinearReport &report)
  {
    typename StepProblem<dim>::Linearization linearization;
    linearization.viscosity = viscosity_linearization(problem);

    if (report.iterations == 1)
    {
      motion             = true;
      multipliers_follow = false;
      motion_increment   = largest_motion_increment;
      problem.assemble(linearization);
    }
    linearization.motion     = motion;
    report.momentum_residual = problem.momentum_residual_norm();
    report.mass_residual     = problem.mass_residual_norm();
    report.linear_iterations += find_increments(problem);

    double start = problem.work_along_increment();
    problem.take_step(1.);
    if (motion && (problem.was_damped() || start > 0.))
    {
      linearization.motion = motion = false;
      motion_increment *= motion_increment_factor;
      problem.take_step(0.);
      problem.assemble(linearization);
      report.linear_iterations += find_increments(problem);
      start = problem.work_along_increment();
      problem.take_step(1.);
    }
    report.velocity_increment = problem.velocity_increment();
    report.pressure_increment = problem.pressure_increment();
    report.is_settled         = problem.is_settled();
    const bool is_exact       = problem.fluids().any_exact_yield_stress();
    if (is_exact && are_increments_small(report))
      find_yield_gap(problem, report);
    if (is_converged(problem, report))
      return;
    problem.end_iteration();

    if (report.velocity_increment < motion_increment)
      linearization.motion = motion = true;

    // Multipliers change after a full step, never inside the line search: they belong to the function that it makes
    // smaller. Most full steps do not overshoot, so that one assembly, after the change, does for both.
    multipliers_follow = multipliers_follow || report.velocity_increment < multiplier_increment;
    const bool are_due = is_exact && !problem.was_damped() &&
                         (report.iterations > n_eager_iterations ? are_increments_small(report)
                                                                 : multipliers_follow);
    const double work_of_update = are_due ? problem.update_multipliers() : 0.;

    // The assembly at the end of the step tells whether it overshoots, and serves the next iteration.
    problem.assemble(linearization);
    double length = 1., end = problem.work_along_increment() - work_of_update;
    const auto overshoots = [&]() { return start < 0. && end > -overshoot * start; };
    if (are_due && overshoots())
    {
      problem.take_multipliers_back();
      problem.assemble(linearization);
      end = problem.work_along_increment();
    }
    linearization.plastic_weight = overshoot_weight;
    for (unsigned int trial = 0; trial < n_trial_steps && overshoots(); ++trial)
    {
      length *= std::max(shortest_search, start / (start - end));
      problem.take_step(length);
      problem.assemble(linearization);
      end = problem.work_along_increment();
    }
  }



  template class NonlinearScheme<2>;
  template class NonlinearScheme<3>;
} // namespace Lahar
