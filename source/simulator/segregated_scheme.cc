// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/nonlinear_scheme.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * Finds the increments of the velocities for given pressures, then those of the pressures, and corrects both in a
   * few more sweeps, see LinearSolver::solve_in_two_steps().
   *
   * Franci & Zhang (2018) make one sweep for every assembly, with H alone for the pressures and a pseudo bulk modulus
   * in K to make up for it. With S no such parameter is needed, and without plugs one sweep would do. In plugs
   * diag(K)⁻¹ says little about K⁻¹; the corrections find the few directions in which it does not.
   */
  template <int dim>
  class SegregatedScheme : public NonlinearScheme<dim>
  {
  protected:
    unsigned int find_increments(StepProblem<dim> &problem) const override
    {
      return problem.solve(this->negligible_error(), true);
    }
  };



  static const Factory<NonlinearScheme<2>>::Registration<SegregatedScheme<2>>
    segregated_2d("segregated", "Those of velocity first, then of pressure, with a few corrections of both.");
  static const Factory<NonlinearScheme<3>>::Registration<SegregatedScheme<3>>
    segregated_3d("segregated", "Those of velocity first, then of pressure, with a few corrections of both.");
} // namespace Lahar
