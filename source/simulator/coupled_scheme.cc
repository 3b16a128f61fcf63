// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/nonlinear_scheme.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Finds the increments of velocity and pressure together.
  template <int dim>
  class CoupledScheme : public NonlinearScheme<dim>
  {
  protected:
    unsigned int find_increments(StepProblem<dim> &problem) const override
    {
      return problem.solve(this->negligible_error());
    }
  };



  static const Factory<NonlinearScheme<2>>::Registration<CoupledScheme<2>>
    coupled_2d("coupled", "Those of velocity and pressure together.");
  static const Factory<NonlinearScheme<3>>::Registration<CoupledScheme<3>>
    coupled_3d("coupled", "Those of velocity and pressure together.");
} // namespace Lahar
