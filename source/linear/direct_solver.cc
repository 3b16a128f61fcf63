// SPDX-License-Identifier: GPL-3.0-or-later

#include <Amesos.h>
#include <Amesos_Mumps.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <lahar/linear/direct_solver.h>
#include <lahar/linear/scaled_gmres.h>
#include <lahar/linear/schur_complement.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/process_start.h>

#include <stdexcept>

namespace Lahar
{
  namespace
  {
    /// GmresTargets::slack.
    constexpr double slack = 1.5;
    /// Of the tolerance where IncrementScales::are_coarse.
    constexpr double coarse_factor = 5.;
  } // namespace



  template <int dim>
  void DirectSolver<dim>::declare_parameters(Parameters &prm)
  {
    prm.declare_choice("Package", "MUMPS", "MUMPS|KLU", "Package that factorises: MUMPS or KLU.");
    prm.declare_number(
      "Tolerance", "1e-2",
      "Relative tolerance of the increments where an earlier factorisation is used again, 0 to 0.1, five times as "
      "large with an exact yield stress; with 0 every system is factorised.",
      0., 0.1);
    prm.declare_count(
      "Maximum iterations", "6",
      "Factorise anew when an earlier factorisation needs more GMRES iterations or, by their convergence, will "
      "need more, 1 to 100.",
      1, 100);
  }



  template <int dim>
  void DirectSolver<dim>::parse_parameters(Parameters &prm)
  {
    if (prm.get("Package") != "MUMPS" && prm.get("Package") != "KLU")
      prm.throw_wrong_value("Package", "MUMPS|KLU");
    package        = prm.get("Package") == "KLU" ? "Amesos_Klu" : "Amesos_Mumps";
    tolerance      = prm.get_in_range("Tolerance", 0., 0.1);
    max_iterations = prm.get_count("Maximum iterations", 1, 100);
  }



  template <int dim>
  void DirectSolver<dim>::Factorization::analyse(std::unique_ptr<Epetra_CrsMatrix> new_matrix,
                                                 const std::string &package, const unsigned int new_pattern)
  {
    solver.reset();
    matrix          = std::move(new_matrix);
    solution        = std::make_unique<Epetra_MultiVector>(matrix->RowMap(), 1);
    right_hand_side = std::make_unique<Epetra_MultiVector>(matrix->RowMap(), 1);
    problem.SetOperator(matrix.get());
    problem.SetLHS(solution.get());
    problem.SetRHS(right_hand_side.get());

    solver.reset(Amesos().Create(package, problem));
    AssertThrow(solver, ExcMessage("Trilinos was built without " + package + "."));
    Teuchos::ParameterList list;
    list.set("PrintStatus", false);
    list.set("PrintTiming", false);
    list.set("OutputLevel", 0);
    list.sublist("mumps").set("ICNTL(7)", 2);   // ordering by approximate minimum fill
    list.sublist("mumps").set("ICNTL(14)", 60); // working space in reserve, per cent
    solver->SetParameters(list);
    check(solver->SymbolicFactorization(), "The symbolic factorisation (" + package + ") failed");
    pattern = new_pattern;
  }



  template <int dim>
  void DirectSolver<dim>::Factorization::factorize()
  {
    check(solver->NumericFactorization(), "The factorisation of the linear system failed");
  }



  template <int dim>
  void DirectSolver<dim>::Factorization::check(const int status, const std::string &what) const
  {
    auto *mumps = dynamic_cast<Amesos_Mumps *>(solver.get());
    int error   = 0;
    if (mumps != nullptr)
    {
      // Small systems are not for all ranks, but always for the first one.
      if (matrix->Comm().MyPID() == 0)
        error = mumps->GetINFOG()[0];
      matrix->Comm().Broadcast(&error, 1, 0);
    }
    if (status == 0 && error >= 0)
      return;
    // Of the users' guide's list.
    constexpr int no_integers = -7, numerically_singular = -10, no_workspace = -13;
    if (error == no_integers || error == no_workspace)
      throw std::runtime_error(what + ": there is not enough memory" + address_space_limit() +
                               ", 'Linear solver/Type = iterative' needs less.");
    if (mumps == nullptr || error == numerically_singular)
      throw RunError(what + ": the matrix is singular.");
    throw RunError(what + " with MUMPS' error " + std::to_string(error) + ".");
  }



  template <int dim>
  void DirectSolver<dim>::Factorization::apply()
  {
    check(solver->Solve(), "The solution with the factorised linear system failed");
  }



  namespace
  {
    /// First unknown of a node where the unknowns of a node stand side by side: a velocity each, a pressure in the
    /// fluid, of which @p n_fluid_before nodes have smaller numbers.
    template <int dim>
    unsigned int first_unknown(const unsigned int node, const unsigned int n_fluid_before)
    {
      return dim * node + n_fluid_before;
    }

    /**
     * Go through the entries of an own node's velocity rows in that order: @p velocity(k) is called for the k-th
     * neighbour in the velocity graph, and after it @p pressure(l) if this is the l-th one in the graph of the
     * pressures.
     */
    template <int dim, typename Velocity, typename Pressure>
    void for_each_entry(const BlockSystem<dim> &system, const LocalNode node, const Velocity &velocity,
                        const Pressure &pressure)
    {
      const NodalGraph &all = system.velocity_graph(), &fluid = system.graph();
      const unsigned int row = node.value(), number = system.fluid_number(node).value();
      const unsigned int n_fluid  = system.is_fluid(node) ? fluid.degree(number) : 0;
      const unsigned int *columns = n_fluid > 0 ? &fluid.columns[fluid.row_start[number]] : nullptr;
      for (unsigned int k = 0, l = 0; k < all.degree(row); ++k)
      {
        velocity(k);
        if (l < n_fluid &&
            system.local_number(Vertex(columns[l])).value() == all.columns[all.row_start[row] + k])
          pressure(l++);
      }
    }

    /// The block system as one matrix, the unknowns of a node side by side. Only the pattern and room for the values.
    template <int dim>
    std::unique_ptr<Epetra_CrsMatrix> make_interleaved(const BlockSystem<dim> &system)
    {
      const NodalGraph &all = system.velocity_graph(), &fluid = system.graph();
      const unsigned int n_own = system.partition().n_own();

      std::vector<int> unknowns;
      for (const LocalNode i : IndexRange<LocalNode>(system.partition().n_with_rows()))
        for (unsigned int a = 0; a < dim + (system.is_fluid(i) ? 1U : 0U); ++a)
          unknowns.push_back(
            first_unknown<dim>(system.partition().global_numbers()[i].value(), system.pressures_before()[i]) +
            a);
      const auto &communicator = system.matrix().block(0, 0).trilinos_matrix().Comm();
      const Epetra_Map rows(-1, static_cast<int>(first_unknown<dim>(n_own, system.n_own_fluid_nodes())),
                            unknowns.data(), 0, communicator),
        column_map(-1, static_cast<int>(unknowns.size()), unknowns.data(), 0, communicator);

      std::vector<int> row_lengths;
      for (const LocalNode i : system.partition().own_nodes())
      {
        const unsigned int n_fluid = system.is_fluid(i) ? fluid.degree(system.fluid_number(i).value()) : 0;
        row_lengths.insert(row_lengths.end(), dim, dim * all.degree(i.value()) + n_fluid);
        if (system.is_fluid(i))
          row_lengths.push_back((dim + 1) * n_fluid);
      }
      auto matrix = std::make_unique<Epetra_CrsMatrix>(Copy, rows, column_map, row_lengths.data(), true);

      std::vector<int> velocity_row, pressure_row;
      std::vector<double> zeros;
      for (const LocalNode i : system.partition().own_nodes())
      {
        velocity_row.clear();
        pressure_row.clear();
        for_each_entry(
          system, i,
          [&](const unsigned int k) {
            const LocalNode column(all.columns[all.row_start[i.value()] + k]);
            for (unsigned int b = 0; b < dim; ++b)
              velocity_row.push_back(first_unknown<dim>(column.value(), system.fluid_number(column).value()) +
                                     b);
          },
          [&](const unsigned int) {
            velocity_row.push_back(velocity_row.back() + 1);
            pressure_row.insert(pressure_row.end(), velocity_row.end() - dim - 1, velocity_row.end());
          });
        zeros.assign(velocity_row.size(), 0.);
        const unsigned int row = first_unknown<dim>(i.value(), system.fluid_number(i).value());
        for (unsigned int a = 0; a < dim; ++a)
          matrix->InsertMyValues(row + a, velocity_row.size(), zeros.data(), velocity_row.data());
        if (system.is_fluid(i))
          matrix->InsertMyValues(row + dim, pressure_row.size(), zeros.data(), pressure_row.data());
      }
      matrix->FillComplete(rows, rows);
      matrix->OptimizeStorage();
      return matrix;
    }

    template <int dim>
    void copy_values(const BlockSystem<dim> &system, Epetra_CrsMatrix &matrix)
    {
      int *row_start, *columns;
      double *values;
      matrix.ExtractCrsDataPointers(row_start, columns, values);

      const double *K = system.values(0, 0), *Q = system.values(0, 1), *C = system.values(1, 0),
                   *H = system.values(1, 1);
      for (const LocalNode i : system.partition().own_nodes())
      {
        for (unsigned int a = 0; a < dim; ++a)
          for_each_entry(
            system, i,
            [&](const unsigned int) {
              for (unsigned int b = 0; b < dim; ++b)
                *values++ = *K++;
            },
            [&](const unsigned int) { *values++ = *Q++; });
        if (system.is_fluid(i))
          for (unsigned int k = 0; k < system.graph().degree(system.fluid_number(i).value()); ++k)
          {
            for (unsigned int b = 0; b < dim; ++b)
              *values++ = *C++;
            *values++ = *H++;
          }
      }
    }
  } // namespace



  template <int dim>
  void DirectSolver<dim>::factorize_whole(const BlockSystem<dim> &system)
  {
    if (whole.pattern != system.pattern_number())
    {
      auto matrix = make_interleaved(system);
      copy_values(system, *matrix);
      whole.analyse(std::move(matrix), package, system.pattern_number());
    }
    else
      copy_values(system, *whole.matrix);
    whole.factorize();
  }



  template <int dim>
  void DirectSolver<dim>::apply_whole(const Vector &right_hand_side, Vector &solution)
  {
    const unsigned int n_fluid_nodes = right_hand_side.block(1).locally_owned_size(),
                       n_nodes       = right_hand_side.block(0).locally_owned_size() / dim;
    const double *v = right_hand_side.block(0).begin(), *p = right_hand_side.block(1).begin();
    double *interleaved = (*whole.right_hand_side)[0];
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      for (unsigned int a = 0; a < dim; ++a)
        *interleaved++ = *v++;
      if (i < n_fluid_nodes)
        *interleaved++ = *p++;
    }
    whole.apply();

    interleaved   = (*whole.solution)[0];
    double *v_out = solution.block(0).begin(), *p_out = solution.block(1).begin();
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      for (unsigned int a = 0; a < dim; ++a)
        *v_out++ = *interleaved++;
      if (i < n_fluid_nodes)
        *p_out++ = *interleaved++;
    }
  }



  template <int dim>
  unsigned int DirectSolver<dim>::solve(const BlockSystem<dim> &system, const IncrementScales &scales,
                                        Vector &solution)
  {
    if (tolerance > 0. && whole.pattern == system.pattern_number())
    {
      const double target             = scales.are_coarse ? coarse_factor * tolerance : tolerance;
      const unsigned int n_iterations = solve_by_scaled_gmres<dim>(
        system, [this](const Vector &x, Vector &y) { apply_whole(x, y); }, scales,
        {max_iterations, target, slack}, solution);
      if (n_iterations <= max_iterations)
        return n_iterations;
    }
    factorize_whole(system);
    apply_whole(system.right_hand_side(), solution);
    return 1;
  }



  template <int dim>
  void DirectSolver<dim>::start_blocks(const BlockSystem<dim> &system)
  {
    for (unsigned int b = 0; b < 2; ++b)
    {
      blocks[b].analyse(b == 0
                          ? std::make_unique<Epetra_CrsMatrix>(system.matrix().block(0, 0).trilinos_matrix())
                          : make_schur_complement(system),
                        package, 0);
      blocks[b].factorize();
    }
  }



  template <int dim>
  void DirectSolver<dim>::solve_block(const unsigned int b, const BlockVector &right_hand_side,
                                      BlockVector &solution)
  {
    Factorization &block = blocks[b];
    std::copy(right_hand_side.begin(), right_hand_side.end(), (*block.right_hand_side)[0]);
    block.apply();
    std::copy_n((*block.solution)[0], solution.locally_owned_size(), solution.begin());
  }



  template <int dim>
  void DirectSolver<dim>::forget()
  {
    LinearSolver<dim>::forget();
    whole.pattern = 0;
  }



  template class DirectSolver<2>;
  template class DirectSolver<3>;



  static const Factory<LinearSolver<2>>::Registration<DirectSolver<2>>
    direct_2d("direct", "A factorisation, which several ranks do not make faster.", "Direct");
  static const Factory<LinearSolver<3>>::Registration<DirectSolver<3>>
    direct_3d("direct", "A factorisation, which several ranks do not make faster.", "Direct");
} // namespace Lahar
