#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <lahar/linear/block_system.h>

#include <algorithm>
#include <cstring>

namespace Lahar
{
  template <int dim>
  BlockSystem<dim>::BlockSystem(const MPI_Comm &communicator)
    : communicator(communicator)
  {}



  template <int dim>
  void BlockSystem<dim>::make_graph(const unsigned int n_nodes)
  {
    // Count, fill, sort and thin out the neighbours of every node.
    std::vector<unsigned int> start(n_nodes + 1, 0);
    for (const Cell &cell : cells)
      for (const unsigned int node : cell)
        start[node + 1] += n_corners;
    for (unsigned int i = 0; i < n_nodes; ++i)
      start[i + 1] += start[i];
    std::vector<unsigned int> all(start[n_nodes]), end(start.begin(), start.end() - 1);
    for (const Cell &cell : cells)
      for (const unsigned int node : cell)
        for (const unsigned int neighbour : cell)
          all[end[node]++] = neighbour;

    nodal_graph.row_start.assign(1, 0);
    nodal_graph.columns.clear();
    nodal_graph.columns.reserve(all.size() / 2);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      std::sort(all.begin() + start[i], all.begin() + end[i]);
      nodal_graph.columns.insert(nodal_graph.columns.end(), all.begin() + start[i],
                                 std::unique(all.begin() + start[i], all.begin() + end[i]));
      nodal_graph.row_start.push_back(nodal_graph.columns.size());
    }

    places.resize(cells.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int I = 0; I < n_corners; ++I)
      {
        const auto row_begin = nodal_graph.columns.begin() + nodal_graph.row_start[cells[c][I]];
        const auto row_end   = nodal_graph.columns.begin() + nodal_graph.row_start[cells[c][I] + 1];
        for (unsigned int J = 0; J < n_corners; ++J)
          places[c][I * n_corners + J] = std::lower_bound(row_begin, row_end, cells[c][J]) - row_begin;
      }
  }



  namespace
  {
    /// A matrix with @p row_components rows and @p column_components columns for each entry of the nodal graph.
    void make_block(const NodalGraph &graph, const unsigned int row_components,
                    const unsigned int column_components, const Epetra_Comm &communicator,
                    TrilinosWrappers::SparseMatrix &matrix)
    {
      const unsigned int n_nodes = graph.row_start.size() - 1;
      const Epetra_Map rows(static_cast<int>(n_nodes * row_components), 0, communicator);
      const Epetra_Map columns(static_cast<int>(n_nodes * column_components), 0, communicator);

      std::vector<int> row_lengths(n_nodes * row_components);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int a = 0; a < row_components; ++a)
          row_lengths[i * row_components + a] = (graph.row_start[i + 1] - graph.row_start[i]) *
                                                column_components;

      Epetra_CrsGraph crs_graph(Copy, rows, columns, row_lengths.data(), true);
      std::vector<int> indices;
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        indices.clear();
        for (unsigned int k = graph.row_start[i]; k < graph.row_start[i + 1]; ++k)
          for (unsigned int b = 0; b < column_components; ++b)
            indices.push_back(graph.columns[k] * column_components + b);
        for (unsigned int a = 0; a < row_components; ++a)
          crs_graph.InsertMyIndices(i * row_components + a, indices.size(), indices.data());
      }
      crs_graph.FillComplete(columns, rows);
      crs_graph.OptimizeStorage();

      Epetra_CrsMatrix crs_matrix(Copy, crs_graph);
      crs_matrix.FillComplete(columns, rows);
      matrix.reinit(crs_matrix, true);
    }

    double *values_of(const TrilinosWrappers::SparseMatrix &matrix)
    {
      int *row_start, *columns;
      double *values;
      auto &crs_matrix = const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
      crs_matrix.OptimizeStorage();
      const int error = crs_matrix.ExtractCrsDataPointers(row_start, columns, values);
      AssertThrow(error == 0, ExcMessage("Trilinos does not give the matrix's arrays."));
      (void) error;
      return values;
    }
  } // namespace



  template <int dim>
  void BlockSystem<dim>::reinit(const unsigned int n_nodes, const std::vector<Cell> &new_cells)
  {
    cells = new_cells;
    ++n_reinits;
    make_graph(n_nodes);

    const Epetra_MpiComm epetra_communicator(communicator);
    const unsigned int components[2] = {dim, 1};
    block_matrix.reinit(2, 2);
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < 2; ++column)
      {
        make_block(nodal_graph, components[row], components[column], epetra_communicator,
                   block_matrix.block(row, column));
        block_values[row][column] = values_of(block_matrix.block(row, column));
      }
    block_matrix.collect_sizes();

    constraints.assign(n_nodes, NodeConstraint<dim>());
    any_skew = false;
    rhs      = make_vector();
    for (unsigned int b = 0; b < 2; ++b)
      rhs_values[b] = rhs.block(b).begin();
    residuals.resize(n_nodes);
  }



  template <int dim>
  typename BlockSystem<dim>::Vector BlockSystem<dim>::make_vector() const
  {
    const unsigned int n = nodal_graph.row_start.size() - 1;
    return Vector({complete_index_set(dim * n), complete_index_set(n)}, communicator);
  }



  template <int dim>
  void BlockSystem<dim>::set_constraints(const std::vector<NodeConstraint<dim>> &new_constraints)
  {
    AssertDimension(new_constraints.size(), n_nodes());
    constraints = new_constraints;
    any_skew = std::any_of(constraints.begin(), constraints.end(), [](const NodeConstraint<dim> &constraint) {
      return constraint.n_fixed > 0 && constraint.n_fixed < dim;
    });
  }



  template <int dim>
  void BlockSystem<dim>::set_zero()
  {
    const std::size_t n_entries     = nodal_graph.columns.size();
    const std::size_t components[2] = {dim, 1};
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < 2; ++column)
        std::memset(block_values[row][column], 0,
                    n_entries * components[row] * components[column] * sizeof(double));
    rhs = 0.;
    std::fill(residuals.begin(), residuals.end(), Tensor<1, dim>());
  }



  template <int dim>
  void BlockSystem<dim>::rotate(
    const Cell &cell, std::array<std::array<double, n_corners * n_corners>, n_corners * n_corners> &matrix,
    std::array<double, n_corners * n_corners> &residual) const
  {
    for (unsigned int I = 0; I < n_corners; ++I)
    {
      const NodeConstraint<dim> &constraint = constraints[cell[I]];
      if (constraint.n_fixed == 0 || constraint.n_fixed == dim)
        continue;
      const unsigned int first = I * n_corners;
      const auto rotated       = [&](const auto &get, const auto &set) {
        std::array<double, dim> old;
        for (unsigned int a = 0; a < dim; ++a)
          old[a] = get(first + a);
        for (unsigned int a = 0; a < dim; ++a)
        {
          double sum = 0.;
          for (unsigned int b = 0; b < dim; ++b)
            sum += constraint.frame[a][b] * old[b];
          set(first + a, sum);
        }
      };
      for (unsigned int k = 0; k < n_corners * n_corners; ++k)
        rotated([&](const unsigned int a) { return matrix[a][k]; },
                [&](const unsigned int a, const double value) { matrix[a][k] = value; });
      for (unsigned int k = 0; k < n_corners * n_corners; ++k)
        rotated([&](const unsigned int a) { return matrix[k][a]; },
                [&](const unsigned int a, const double value) { matrix[k][a] = value; });
      rotated([&](const unsigned int a) { return residual[a]; },
              [&](const unsigned int a, const double value) { residual[a] = value; });
    }
  }



  template <int dim>
  void BlockSystem<dim>::add(
    const unsigned int c,
    const std::array<std::array<double, n_corners * n_corners>, n_corners * n_corners> &matrix,
    const std::array<double, n_corners * n_corners> &residual)
  {
    const Cell &cell = cells[c];
    for (unsigned int I = 0; I < n_corners; ++I)
      for (unsigned int a = 0; a < dim; ++a)
        residuals[cell[I]][a] += residual[I * n_corners + a];

    unsigned int n_fixed[n_corners];
    bool any_fixed = false;
    for (unsigned int I = 0; I < n_corners; ++I)
    {
      n_fixed[I] = constraints[cell[I]].n_fixed;
      any_fixed  = any_fixed || n_fixed[I] > 0;
    }

    auto local_matrix   = matrix;
    auto local_residual = residual;
    if (any_fixed)
    {
      if (any_skew)
        rotate(cell, local_matrix, local_residual);
      for (unsigned int I = 0; I < n_corners; ++I)
        for (unsigned int a = 0; a < n_fixed[I]; ++a)
        {
          const unsigned int i  = I * n_corners + a;
          const double diagonal = local_matrix[i][i];
          for (unsigned int k = 0; k < n_corners * n_corners; ++k)
            local_matrix[i][k] = local_matrix[k][i] = 0.;
          local_matrix[i][i] = std::abs(diagonal);
          local_residual[i]  = 0.;
        }
    }

    for (unsigned int I = 0; I < n_corners; ++I)
    {
      const std::size_t start  = nodal_graph.row_start[cell[I]];
      const std::size_t degree = nodal_graph.row_start[cell[I] + 1] - start;
      for (unsigned int a = 0; a < dim; ++a)
        rhs_values[0][dim * cell[I] + a] -= local_residual[I * n_corners + a];
      rhs_values[1][cell[I]] -= local_residual[I * n_corners + dim];

      for (unsigned int J = 0; J < n_corners; ++J)
      {
        const unsigned int place = places[c][I * n_corners + J];
        for (unsigned int a = 0; a < dim; ++a)
        {
          const double *row = &local_matrix[I * n_corners + a][J * n_corners];
          double *K         = block_values[0][0] + dim * dim * start + dim * (a * degree + place);
          for (unsigned int b = 0; b < dim; ++b)
            K[b] += row[b];
          block_values[0][1][dim * start + a * degree + place] += row[dim];
        }
        const double *row = &local_matrix[I * n_corners + dim][J * n_corners];
        for (unsigned int b = 0; b < dim; ++b)
          block_values[1][0][dim * (start + place) + b] += row[b];
        block_values[1][1][start + place] += row[dim];
      }
    }
  }



  template <int dim>
  Tensor<1, dim> BlockSystem<dim>::velocity(const Vector &solution, const unsigned int node) const
  {
    Tensor<1, dim> in_frame;
    const double *values = solution.block(0).begin();
    for (unsigned int a = 0; a < dim; ++a)
      in_frame[a] = values[dim * node + a];
    const NodeConstraint<dim> &constraint = constraints[node];
    return (constraint.n_fixed == 0 || constraint.n_fixed == dim) ? in_frame
                                                                  : transpose(constraint.frame) * in_frame;
  }



  template <int dim>
  double BlockSystem<dim>::pressure(const Vector &solution, const unsigned int node) const
  {
    return solution.block(1).begin()[node];
  }



  template class BlockSystem<2>;
  template class BlockSystem<3>;
} // namespace Lahar
