// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/direct_solver.h>
#include <lahar/linear/iterative_solver.h>
#include <lahar/linear/linear_solver.h>

namespace Lahar
{
  template <int dim>
  void LinearSolver<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Linear solver");
    prm.declare_entry(
      "Type", dim == 2 ? "direct" : "iterative", Patterns::Anything(),
      "'direct': factorisation, which several ranks do not make faster; 'iterative': GMRES with a block "
      "preconditioner.");
    DirectSolver<dim>::declare_parameters(prm);
    IterativeSolver<dim>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  std::unique_ptr<LinearSolver<dim>> LinearSolver<dim>::create(Parameters &prm)
  {
    prm.enter_subsection("Linear solver");
    const std::string type = prm.get("Type");
    if (type != "direct" && type != "iterative")
      prm.throw_wrong_value("Type", "direct|iterative");
    auto direct    = std::make_unique<DirectSolver<dim>>();
    auto iterative = std::make_unique<IterativeSolver<dim>>();
    direct->parse_parameters(prm);
    iterative->parse_parameters(prm);
    prm.leave_subsection();
    if (type == "iterative")
      return iterative;
    return direct;
  }



  template class LinearSolver<2>;
  template class LinearSolver<3>;
} // namespace Lahar
