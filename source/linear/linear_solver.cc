// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/linear_solver.h>
#include <lahar/linear/scaled_gmres.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  namespace
  {
    // See GmresTargets. The nonlinear iteration gains nothing from better increments.
    constexpr double sweep_tolerance   = 0.01;
    constexpr unsigned int most_sweeps = 60;

    /// The same for sweeps with the blocks of an earlier system.
    constexpr double reused_sweeps_slack       = 1.5;
    constexpr unsigned int most_earlier_sweeps = 6;
  } // namespace



  template <int dim>
  void LinearSolver<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Linear solver");
    Factory<LinearSolver>::declare_choice(prm, "Type", dim == 2 ? "direct" : "iterative",
                                          "How linear systems are solved.");
    Factory<LinearSolver>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  std::unique_ptr<LinearSolver<dim>> LinearSolver<dim>::create(Parameters &prm)
  {
    prm.enter_subsection("Linear solver");
    const std::string type = Factory<LinearSolver>::choice(prm, "Type");
    std::unique_ptr<LinearSolver> chosen;
    for (const std::string &name : split_list(Factory<LinearSolver>::names(), '|'))
    {
      std::unique_ptr<LinearSolver> solver = Factory<LinearSolver>::create(name, prm);
      if (name == type)
        chosen = std::move(solver);
    }
    prm.leave_subsection();
    return chosen;
  }



  template <int dim>
  unsigned int LinearSolver<dim>::solve_in_two_steps(const BlockSystem<dim> &system,
                                                     const IncrementScales &scales, Vector &solution)
  {
    BlockVector rest = system.right_hand_side().block(1);
    for (const bool fresh : {false, true})
    {
      if (!fresh && blocks_pattern != system.pattern_number())
        continue;
      if (fresh)
        start_blocks(system);
      blocks_pattern = system.pattern_number();

      const GmresTargets targets  = fresh ? GmresTargets{most_sweeps, sweep_tolerance}
                                          : GmresTargets{most_earlier_sweeps, sweep_tolerance,
                                                        reused_sweeps_slack};
      const unsigned int n_sweeps = solve_by_scaled_gmres<dim>(
        system,
        [&](const Vector &x, Vector &y) {
          solve_block(0, x.block(0), y.block(0));
          system.matrix().block(1, 0).vmult(rest, y.block(0));
          rest.sadd(-1., 1., x.block(1));
          solve_block(1, rest, y.block(1));
        },
        scales, targets, solution);
      if (n_sweeps <= targets.max_iterations)
        return n_sweeps;
    }
    throw RunError("Velocities and pressures do not agree after " + std::to_string(most_sweeps) +
                   " solutions for each.");
  }



  template <int dim>
  void LinearSolver<dim>::forget()
  {
    blocks_pattern = 0;
  }



  template class LinearSolver<2>;
  template class LinearSolver<3>;
} // namespace Lahar
