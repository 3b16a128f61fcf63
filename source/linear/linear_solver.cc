#include <lahar/linear/direct_solver.h>
#include <lahar/linear/linear_solver.h>

namespace Lahar
{
  template <int dim>
  void LinearSolver<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Linear solver");
    DirectSolver<dim>::declare_parameters(prm);
    prm.leave_subsection();
  }



  template <int dim>
  std::unique_ptr<LinearSolver<dim>> LinearSolver<dim>::create(Parameters &prm)
  {
    prm.enter_subsection("Linear solver");
    auto direct = std::make_unique<DirectSolver<dim>>();
    direct->parse_parameters(prm);
    prm.leave_subsection();
    return direct;
  }



  template class LinearSolver<2>;
  template class LinearSolver<3>;
} // namespace Lahar
