// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/lac/solver_gmres.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <lahar/linear/iterative_solver.h>
#include <lahar/linear/scaled_gmres.h>
#include <lahar/linear/schur_complement.h>
#include <lahar/utilities/factory.h>

#include <array>
#include <string>

namespace Lahar
{
  namespace
  {
    /// An approximate inverse with which GMRES takes more than this times the iterations of a fresh one is made anew.
    constexpr double largest_growth = 1.5;
  } // namespace



  template <int dim>
  void IterativeSolver<dim>::declare_parameters(Parameters &prm)
  {
    prm.declare_choice(
      "Preconditioner", "ML", "ML|ILU",
      "Of the velocity block and of the pressure's Schur complement: 'ML' (algebraic "
      "multigrid; of the Schur complement incomplete factors where GMRES fails) or 'ILU' (incomplete "
      "factors).");
    prm.declare_number(
      "Tolerance", "1e-3",
      "Tolerance of the preconditioned residual relative to the first one, with velocity and "
      "pressure divided by their sizes, 1e-12 to 0.1. Where the preconditioner is poor, GMRES goes on "
      "until its estimate of the error is below a tenth of the solution.",
      1e-12, 0.1);
    prm.declare_count("Maximum iterations", "200",
                      "A time step in which GMRES needs more iterations has failed, 1 to 1000.", 1, 1000);
  }



  template <int dim>
  void IterativeSolver<dim>::parse_parameters(Parameters &prm)
  {
    if (prm.get("Preconditioner") != "ML" && prm.get("Preconditioner") != "ILU")
      prm.throw_wrong_value("Preconditioner", "ML|ILU");
    multigrid      = prm.get("Preconditioner") == "ML";
    tolerance      = prm.get_in_range("Tolerance", 1e-12, 0.1);
    max_iterations = prm.get_count("Maximum iterations", 1, 1000);
  }



  template <int dim>
  typename IterativeSolver<dim>::Preconditioner
  IterativeSolver<dim>::make_preconditioner(const Matrix &matrix, const unsigned int n_components,
                                            const BlockSystem<dim> &system, const bool by_multigrid) const
  {
    if (by_multigrid)
    {
      auto preconditioner = std::make_unique<TrilinosWrappers::PreconditionAMG>();
      TrilinosWrappers::PreconditionAMG::AdditionalData data;
      data.constant_modes.assign(n_components, std::vector<bool>(matrix.m(), false));
      for (unsigned int i = 0; i < matrix.m(); ++i)
        data.constant_modes[i % n_components][i] = true;
      Teuchos::ParameterList list;
      std::unique_ptr<Epetra_MultiVector> modes;
      data.set_parameters(list, modes, matrix);
      list.set("PDE equations", static_cast<int>(n_components)); // aggregates are made of nodes
      std::array<std::vector<double>, dim> coordinates;
      if (n_components == dim && system.has_solids())
      {
        list.set("null space: type", "elasticity from coordinates"); // translations and rotations
        for (unsigned int d = 0; d < dim; ++d)
        {
          for (const Point<dim> &x : system.positions())
            coordinates[d].push_back(x[d]);
          list.set(std::string(1, "xyz"[d]) + "-coordinates", coordinates[d].data());
        }
      }
      list.set("coarse: max size", 300); // larger ones cost more to factorise than a level more
      preconditioner->initialize(matrix, list);
      return preconditioner;
    }
    auto preconditioner = std::make_unique<TrilinosWrappers::PreconditionILU>();
    // In multigrid's place for S̃, whose rows reach over two layers of nodes already.
    const unsigned int fill = multigrid ? 0 : 1;
    preconditioner->initialize(matrix, TrilinosWrappers::PreconditionILU::AdditionalData(fill));
    return preconditioner;
  }



  template <int dim>
  void IterativeSolver<dim>::make_inverse(const BlockSystem<dim> &system, const bool schur_by_multigrid)
  {
    // The system's matrix will change: the smoothers need one that does not.
    inverse                     = std::make_unique<ApproximateInverse>();
    inverse->schur_by_multigrid = schur_by_multigrid;
    inverse->K.copy_from(system.matrix().block(0, 0));
    inverse->S.reinit(*make_schur_complement(system), true);
    inverse->inverse_K = make_preconditioner(inverse->K, dim, system, multigrid);
    inverse->inverse_S = make_preconditioner(inverse->S, 1, system, schur_by_multigrid);
    inverse->pattern   = system.pattern_number();
  }



  template <int dim>
  unsigned int IterativeSolver<dim>::solve(const BlockSystem<dim> &system, const IncrementScales &scales,
                                           Vector &solution)
  {
    for (bool is_last_try = false; !is_last_try;)
    {
      const bool fits  = inverse && inverse->pattern == system.pattern_number();
      const bool fresh = !fits || inverse->worn;
      if (fresh)
        make_inverse(system, multigrid && !(fits && inverse->multigrid_failed));
      is_last_try = fresh && !inverse->schur_by_multigrid;

      auto pressure_rhs               = system.right_hand_side().block(1);
      const unsigned int n_iterations = solve_by_scaled_gmres<dim>(
        system,
        [&](const Vector &x, Vector &y) {
          inverse->inverse_K->vmult(y.block(0), x.block(0));
          system.matrix().block(1, 0).vmult(pressure_rhs, y.block(0));
          pressure_rhs.sadd(-1., 1., x.block(1));
          inverse->inverse_S->vmult(y.block(1), pressure_rhs);
        },
        scales, {max_iterations, tolerance}, solution);
      const bool converged = n_iterations <= max_iterations;
      if (fresh)
        inverse->n_fresh_iterations = n_iterations;
      inverse->worn             = !converged || n_iterations > largest_growth * inverse->n_fresh_iterations;
      inverse->multigrid_failed = !inverse->schur_by_multigrid || (fresh && !converged);
      if (converged)
        return n_iterations;
    }
    throw RunError("GMRES did not converge in " + std::to_string(max_iterations) + " iterations.");
  }



  template <int dim>
  void IterativeSolver<dim>::start_blocks(const BlockSystem<dim> &system)
  {
    make_inverse(system, multigrid);
  }



  template <int dim>
  void IterativeSolver<dim>::solve_block(const unsigned int b, const BlockVector &right_hand_side,
                                         BlockVector &solution)
  {
    const Preconditioner &preconditioner = b == 0 ? inverse->inverse_K : inverse->inverse_S;
    BlockVector scaled                   = right_hand_side;
    preconditioner->vmult(scaled, right_hand_side);
    SolverControl control(max_iterations, tolerance * scaled.l2_norm(), false, false);
    SolverGMRES<BlockVector> gmres(control,
                                   typename SolverGMRES<BlockVector>::AdditionalData(max_iterations + 2));
    solution = 0.;
    try
    {
      gmres.solve(b == 0 ? inverse->K : inverse->S, solution, right_hand_side, *preconditioner);
    }
    catch (const SolverControl::NoConvergence &)
    {
      throw RunError("GMRES did not converge in " + std::to_string(max_iterations) + " iterations.");
    }
  }



  template <int dim>
  void IterativeSolver<dim>::forget()
  {
    LinearSolver<dim>::forget();
    inverse.reset();
  }



  template class IterativeSolver<2>;
  template class IterativeSolver<3>;



  static const Factory<LinearSolver<2>>::Registration<IterativeSolver<2>>
    iterative_2d("iterative", "GMRES with a block preconditioner.", "Iterative");
  static const Factory<LinearSolver<3>>::Registration<IterativeSolver<3>>
    iterative_3d("iterative", "GMRES with a block preconditioner.", "Iterative");
} // namespace Lahar
