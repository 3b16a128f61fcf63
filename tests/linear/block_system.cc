// SPDX-License-Identifier: GPL-3.0-or-later

// Test the block system against a dense assembly with fixed and skew nodes and fixed pressures, and the solutions of the linear solvers
// against LAPACK, with a fresh and with a reused factorisation. On several ranks the nodes are shared out.

#include <deal.II/base/utilities.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <lahar/geometry/delaunay.h>
#include <lahar/linear/direct_solver.h>

#include "tests.h"

using namespace Tests;

/// Node and component of the unknowns as the block system numbers them: velocities first.
template <int dim>
unsigned int index(const unsigned int n_nodes, const unsigned int node, const unsigned int component)
{
  return component < dim ? dim * node + component : dim * n_nodes + node;
}

/// Random cell systems, diagonally dominant so that the sum is regular; the same for the same seed.
template <int dim>
struct Example
{
  static constexpr unsigned int n_local = (dim + 1) * (dim + 1);
  using Matrix                          = std::array<std::array<double, n_local>, n_local>;

  std::vector<Point<dim>> points;
  std::vector<Simplex<dim>> cells;
  std::vector<NodeConstraint<dim>> constraints;
  std::vector<Matrix> matrices;
  std::vector<std::array<double, n_local>> residuals;
  unsigned int n_nodes = 0;

  explicit Example(Random &random)
  {
    for (unsigned int i = 0; i < 12 * dim; ++i)
      points.push_back(Point<dim>(random.vector<dim>()));
    n_nodes = points.size();
    cells   = delaunay(points);
    matrices.resize(cells.size());
    residuals.resize(cells.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int i = 0; i < n_local; ++i)
      {
        residuals[c][i] = random.number();
        for (unsigned int j = 0; j < n_local; ++j)
          matrices[c][i][j] = random.number() + (i == j ? 6. : 0.);
      }

    constraints.resize(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      constraints[i].n_fixed        = i % (dim + 2) <= dim ? i % (dim + 2) : 0;
      constraints[i].fixed_pressure = i % 7 == 0;
      if (constraints[i].n_fixed > 0 && constraints[i].n_fixed < dim)
      {
        // An orthonormal frame by Gram-Schmidt.
        for (unsigned int a = 0; a < dim; ++a)
        {
          Tensor<1, dim> row = random.vector<dim>();
          for (unsigned int b = 0; b < a; ++b)
            row -= (row * constraints[i].frame[b]) * constraints[i].frame[b];
          constraints[i].frame[a] = row / row.norm();
        }
      }
    }
  }

  void add_to(BlockSystem<dim> &system) const
  {
    system.set_zero();
    for (unsigned int k = 0; k < system.cells().size(); ++k)
      system.add(k, matrices[system.cells()[k]], residuals[system.cells()[k]]);
  }
};

/// All entries of a vector, on all ranks.
template <int dim>
Vector<double> all_entries(const typename BlockSystem<dim>::Vector &vector)
{
  Vector<double> all(vector.size());
  for (unsigned int b = 0, first = 0; b < 2; first += vector.block(b++).size())
    for (const auto i : vector.block(b).locally_owned_elements())
      all[first + i] = vector.block(b)(i);
  Utilities::MPI::sum(all, MPI_COMM_WORLD, all);
  return all;
}

template <int dim>
double difference(const typename BlockSystem<dim>::Vector &solution, const Vector<double> &reference)
{
  Vector<double> all = all_entries<dim>(solution);
  all -= reference;
  return all.linfty_norm();
}

template <int dim>
void test()
{
  const std::string name = Utilities::int_to_string(dim) + "D ";
  Random random;
  const Example<dim> example(random);
  const unsigned int n = (dim + 1) * example.n_nodes;

  // Dense: sum up without constraints, turn into the frames, strike out what is fixed.
  FullMatrix<double> A(n), T(n), TA(n), B(n);
  Vector<double> residual(n), rhs(n);
  std::vector<Tensor<1, dim>> momentum(example.n_nodes);
  for (unsigned int c = 0; c < example.cells.size(); ++c)
    for (unsigned int i = 0; i < example.n_local; ++i)
    {
      const unsigned int row = index<dim>(example.n_nodes, example.cells[c][i / (dim + 1)], i % (dim + 1));
      residual[row] += example.residuals[c][i];
      if (i % (dim + 1) < dim)
        momentum[example.cells[c][i / (dim + 1)]][i % (dim + 1)] += example.residuals[c][i];
      for (unsigned int j = 0; j < example.n_local; ++j)
        A(row, index<dim>(example.n_nodes, example.cells[c][j / (dim + 1)],
                          j % (dim + 1))) += example.matrices[c][i][j];
    }
  std::vector<bool> fixed(n, false);
  for (unsigned int v = 0; v < example.n_nodes; ++v)
  {
    const NodeConstraint<dim> &constraint = example.constraints[v];
    const bool skew                       = constraint.n_fixed > 0 && constraint.n_fixed < dim;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        T(dim * v + a, dim * v + b) = skew ? constraint.frame[a][b] : (a == b);
    T(dim * example.n_nodes + v, dim * example.n_nodes + v) = 1.;
    for (unsigned int a = 0; a < constraint.n_fixed; ++a)
      fixed[dim * v + a] = true;
    fixed[dim * example.n_nodes + v] = constraint.fixed_pressure;
  }
  T.mmult(TA, A);
  TA.mTmult(B, T);
  T.vmult(rhs, residual);
  rhs *= -1.;
  for (unsigned int i = 0; i < n; ++i)
    if (fixed[i])
    {
      rhs[i] = 0.;
      for (unsigned int j = 0; j < n; ++j)
        B(i, j) = B(j, i) = 0.;
    }

  BlockSystem<dim> system(MPI_COMM_WORLD);
  const IndexVector<RegionNode, Point<dim>> positions(example.points);
  system.reinit(example.n_nodes, example.cells, {}, positions);
  IndexVector<LocalNode, NodeConstraint<dim>> constraints;
  for (const RegionNode node : system.partition().nodes())
    constraints.push_back(example.constraints[node.value()]);
  system.set_constraints(constraints);
  for (unsigned int repetition = 0; repetition < 3; ++repetition)
  {
    if (repetition == 2) // the same cells again: the matrices stay, the constraints do not
    {
      const double *values = system.values(0, 0);
      system.reinit(example.n_nodes, example.cells, {}, positions);
      check(name + "the matrices stay", system.pattern_number() == 1 && system.values(0, 0) == values);
      system.set_constraints(constraints);
    }
    example.add_to(system);
    double error = 0., rhs_error = 0., momentum_error = 0., diagonal = 1e10;
    const Vector<double> system_rhs = all_entries<dim>(system.right_hand_side());
    for (unsigned int i = 0; i < n; ++i)
    {
      rhs_error              = std::max(rhs_error, std::abs(system_rhs[i] - rhs[i]));
      const unsigned int n_v = dim * example.n_nodes, row = i >= n_v ? i - n_v : i;
      const bool own = system.right_hand_side().block(i >= n_v).locally_owned_elements().is_element(row);
      if (fixed[i])
        B(i, i) = Utilities::MPI::max(own ? system.matrix().block(i >= n_v, i >= n_v).el(row, row) : 0.,
                                      MPI_COMM_WORLD);
      if (fixed[i])
        diagonal = std::min(diagonal, B(i, i));
      for (unsigned int j = 0; j < n && own; ++j)
        error = std::max(error,
                         std::abs(system.matrix().block(i >= n_v, j >= n_v).el(row, j >= n_v ? j - n_v : j) -
                                  B(i, j)));
    }
    for (const LocalNode l : system.partition().own_nodes())
      momentum_error =
        std::max(momentum_error,
                 (system.momentum_residual()[l] - momentum[system.partition().nodes()[l].value()]).norm());
    check(name + "matrix equals the dense one", error, 1e-12);
    check(name + "right-hand side equals the dense one", rhs_error, 1e-13);
    check(name + "momentum residual is that without constraints", momentum_error, 1e-13);
    check(name + "fixed unknowns have a positive diagonal", diagonal > 0.);
  }

  LAPACKFullMatrix<double> dense(n, n);
  dense = B;
  dense.compute_lu_factorization();
  Vector<double> reference = rhs;
  dense.solve(reference);

  for (const std::string package : {"MUMPS", "KLU"})
  {
    DirectSolver<dim> solver;
    parse(solver, "set Package = " + package + "\nset Tolerance = 1e-10\n");
    auto solution = system.make_vector();
    example.add_to(system);
    check(name + package + ": one iteration", solver.solve(system, {}, solution) == 1);
    check(name + package + ": solution equals LAPACK's", difference<dim>(solution, reference), 1e-11);

    double velocity_error = 0., pressure_error = 0.;
    const auto velocities = system.velocities(solution);
    const auto pressures  = system.pressures(solution);
    for (const LocalNode l : system.partition().nodes().indices())
    {
      const unsigned int node = system.partition().nodes()[l].value();
      Tensor<1, dim> turned_back;
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          turned_back[b] += T(dim * node + a, dim * node + b) * reference[dim * node + a];
      velocity_error = std::max(velocity_error, (velocities[l] - turned_back).norm());
      pressure_error = std::max(pressure_error, std::abs(pressures[system.fluid_number(l)] -
                                                         reference[dim * example.n_nodes + node]));
    }
    check(name + package + ": velocities of all known nodes, turned back", velocity_error, 1e-11);

    // What an iterative solver leaves in prescribed components does not come back.
    auto inexact            = system.make_vector();
    inexact                 = 1.;
    const auto inexact_ones = system.velocities(inexact);
    double prescribed       = 0.;
    for (const LocalNode l : system.partition().nodes().indices())
    {
      const unsigned int node = system.partition().nodes()[l].value();
      for (unsigned int a = 0; a < example.constraints[node].n_fixed; ++a)
      {
        double component = 0.;
        for (unsigned int b = 0; b < dim; ++b)
          component += T(dim * node + a, dim * node + b) * inexact_ones[l][b];
        prescribed = std::max(prescribed, std::abs(component));
      }
    }
    check(name + package + ": prescribed components are zero", prescribed, 1e-12);
    check(name + package + ": pressures of all known nodes", pressure_error, 1e-11);

    // A slightly different matrix: the old factorisation preconditions GMRES.
    Example<dim> changed(example);
    for (auto &matrix : changed.matrices)
      for (auto &row : matrix)
        for (double &entry : row)
          entry *= 1. + 1e-3 * random.number();
    changed.add_to(system);
    const unsigned int n_iterations = solver.solve(system, {10., 0.1}, solution);
    auto remainder                  = system.make_vector();
    system.matrix().vmult(remainder, solution);
    remainder -= system.right_hand_side();
    check(name + package + ": reused factorisation needs few iterations",
          n_iterations > 1 && n_iterations <= 12);
    check(name + package + ": and solves the new system", remainder.linfty_norm(), 1e-7);

    // No further than to an error that does no harm.
    const auto exact         = solution;
    const double negligible  = 1e-3 * exact.l2_norm();
    const unsigned int fewer = solver.solve(system, {1., 1., negligible}, solution);
    solution -= exact;
    check(name + package + ": fewer where less will do", fewer > 0 && fewer < n_iterations);
    check(name + package + ": and near enough", solution.l2_norm(), 3. * negligible);

    // A very different one: factorised anew.
    for (auto &matrix : changed.matrices)
      for (auto &row : matrix)
        for (double &entry : row)
          entry *= 1. + 0.9 * random.number();
    changed.add_to(system);
    check(name + package + ": off the pace", solver.solve(system, {}, solution) == 1);
    system.matrix().vmult(remainder, solution);
    remainder -= system.right_hand_side();
    check(name + package + ": a different matrix", remainder.linfty_norm(), 1e-7);

    example.add_to(system);
    solver.start_blocks(system);
    for (unsigned int b = 0; b < 2; ++b)
      for (unsigned int repetition = 0; repetition < 2; ++repetition)
      {
        solver.solve_block(b, system.right_hand_side().block(b), solution.block(b));
        system.matrix().block(b, b).vmult(remainder.block(b), solution.block(b));
        if (b == 1)
        {
          // S = H − C diag(K)⁻¹ Q
          auto product = system.make_vector();
          system.matrix().block(0, 1).vmult(product.block(0), solution.block(1));
          for (const auto i : product.block(0).locally_owned_elements())
            product.block(0)(i) = product.block(0)(i) / system.matrix().block(0, 0).diag_element(i);
          product.compress(VectorOperation::insert);
          system.matrix().block(1, 0).vmult(product.block(1), product.block(0));
          remainder.block(1) -= product.block(1);
        }
        remainder.block(b) -= system.right_hand_side().block(b);
        check(name + package + ": one block alone", remainder.block(b).linfty_norm(), 1e-11);
      }
  }

  const std::vector<Simplex<dim>> fewer(example.cells.begin(), example.cells.end() - 1);
  system.reinit(example.n_nodes, fewer, {}, positions);
  check(name + "other cells, other matrices", system.pattern_number() == 2);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  return n_failed > 0;
}
