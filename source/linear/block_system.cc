#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <lahar/linear/block_system.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  BlockSystem<dim>::BlockSystem(const MPI_Comm &communicator)
    : communicator(communicator)
  {}



  namespace
  {
    /// The places of all pairs of nodes of all cells in the rows of a graph.
    template <typename Cell, typename Places>
    void find_places(const NodalGraph &graph, const std::vector<Cell> &cells, Places &places)
    {
      places.resize(cells.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (unsigned int I = 0; I < cells[c].size(); ++I)
          for (unsigned int J = 0; J < cells[c].size(); ++J)
            places[c][I * cells[c].size() + J] = graph.place(cells[c][I], cells[c][J]);
    }

    /**
     * A matrix with @p row_components rows and @p column_components columns for each entry of the graph, in which
     * @p n_row_nodes and @p n_column_nodes nodes exist.
     */
    void make_block(const NodalGraph &graph, const unsigned int n_row_nodes,
                    const unsigned int row_components, const unsigned int n_column_nodes,
                    const unsigned int column_components, const Epetra_Comm &communicator,
                    TrilinosWrappers::SparseMatrix &matrix)
    {
      const Epetra_Map rows(static_cast<int>(n_row_nodes * row_components), 0, communicator);
      const Epetra_Map columns(static_cast<int>(n_column_nodes * column_components), 0, communicator);

      std::vector<int> row_lengths(n_row_nodes * row_components);
      for (unsigned int i = 0; i < n_row_nodes; ++i)
        for (unsigned int a = 0; a < row_components; ++a)
          row_lengths[i * row_components + a] = graph.degree(i) * column_components;

      Epetra_CrsGraph crs_graph(Copy, rows, columns, row_lengths.data(), true);
      std::vector<int> indices;
      for (unsigned int i = 0; i < std::min(n_row_nodes, graph.n_rows()); ++i)
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
  void BlockSystem<dim>::reinit(const unsigned int n_fluid_nodes, const std::vector<Cell> &new_cells,
                                const unsigned int n_solid_nodes,
                                const std::vector<unsigned int> &new_solid_cells,
                                const unsigned int new_nodes_per_solid_cell)
  {
    cells                = new_cells;
    solid_cells          = new_solid_cells;
    nodes_per_solid_cell = new_nodes_per_solid_cell;
    ++n_reinits;
    const unsigned int n_nodes = n_fluid_nodes + n_solid_nodes;
    const CellList fluid_list{cells.empty() ? nullptr : cells.front().data(),
                              static_cast<unsigned int>(cells.size()), n_corners};
    pressure_graph.reinit(n_fluid_nodes, {fluid_list});
    find_places(pressure_graph, cells, places);
    if (solid_cells.empty())
    {
      all_graph       = pressure_graph;
      velocity_places = places;
    }
    else
    {
      const unsigned int n_solid_cells = solid_cells.size() / nodes_per_solid_cell;
      const CellList solid_list{solid_cells.data(), n_solid_cells, nodes_per_solid_cell};
      all_graph.reinit(n_nodes, {fluid_list, solid_list});
      find_places(all_graph, cells, velocity_places);
      solid_places.clear();
      for (unsigned int c = 0; c < n_solid_cells; ++c)
        for (const unsigned int *I = solid_list.begin(c); I != solid_list.end(c); ++I)
          for (const unsigned int *J = solid_list.begin(c); J != solid_list.end(c); ++J)
            solid_places.push_back(all_graph.place(*I, *J));
    }

    const Epetra_MpiComm epetra_communicator(communicator);
    const unsigned int components[2] = {dim, 1}, block_nodes[2] = {n_nodes, n_fluid_nodes};
    block_matrix.reinit(2, 2);
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < 2; ++column)
      {
        make_block(row == 0 && column == 0 ? all_graph : pressure_graph, block_nodes[row], components[row],
                   block_nodes[column], components[column], epetra_communicator,
                   block_matrix.block(row, column));
        block_values[row][column] = values_of(block_matrix.block(row, column));
      }
    block_matrix.collect_sizes();

    constraints.assign(n_nodes, NodeConstraint<dim>());
    any_skew = false;
    rhs      = make_vector();
    for (unsigned int b = 0; b < 2; ++b)
      rhs_values[b] = rhs.block(b).begin();
    residuals.resize(n_fluid_nodes);
    solid_residuals.resize(n_nodes);
  }



  template <int dim>
  typename BlockSystem<dim>::Vector BlockSystem<dim>::make_vector() const
  {
    return Vector({complete_index_set(dim * all_graph.n_rows()), complete_index_set(n_fluid_nodes())},
                  communicator);
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
    const std::size_t components[2] = {dim, 1};
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < 2; ++column)
      {
        const std::size_t n_entries = (row == 0 && column == 0 ? all_graph : pressure_graph).columns.size();
        std::fill_n(block_values[row][column], n_entries * components[row] * components[column], 0.);
      }
    rhs = 0.;
    std::fill(residuals.begin(), residuals.end(), Tensor<1, dim>());
    std::fill(solid_residuals.begin(), solid_residuals.end(), Tensor<1, dim>());
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
      const std::size_t start = pressure_graph.row_start[cell[I]], degree = pressure_graph.degree(cell[I]);
      double *K_rows = block_values[0][0] +
                       dim * dim * static_cast<std::size_t>(all_graph.row_start[cell[I]]);
      const std::size_t K_degree = all_graph.degree(cell[I]);
      for (unsigned int a = 0; a < dim; ++a)
        rhs_values[0][dim * cell[I] + a] -= local_residual[I * n_corners + a];
      rhs_values[1][cell[I]] -= local_residual[I * n_corners + dim];

      for (unsigned int J = 0; J < n_corners; ++J)
      {
        const unsigned int place   = places[c][I * n_corners + J],
                           K_place = velocity_places[c][I * n_corners + J];
        for (unsigned int a = 0; a < dim; ++a)
        {
          const double *row = &local_matrix[I * n_corners + a][J * n_corners];
          double *K         = K_rows + dim * (a * K_degree + K_place);
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
  void BlockSystem<dim>::add_solid(const unsigned int c, FullMatrix<double> &matrix,
                                   dealii::Vector<double> &residual)
  {
    const unsigned int n     = nodes_per_solid_cell;
    const unsigned int *cell = &solid_cells[static_cast<std::size_t>(c) * n];
    for (unsigned int I = 0; I < n; ++I)
    {
      for (unsigned int a = 0; a < dim; ++a)
        solid_residuals[cell[I]][a] += residual[I * dim + a];
      Assert(constraints[cell[I]].n_fixed == 0 || constraints[cell[I]].n_fixed == dim,
             ExcMessage("A solid's node is free or has its whole velocity prescribed."));
      if (constraints[cell[I]].n_fixed == dim)
        for (unsigned int a = 0; a < dim; ++a)
        {
          const unsigned int i  = I * dim + a;
          const double diagonal = matrix(i, i);
          for (unsigned int k = 0; k < n * dim; ++k)
            matrix(i, k) = matrix(k, i) = 0.;
          matrix(i, i) = std::abs(diagonal);
          residual[i]  = 0.;
        }
    }
    for (unsigned int I = 0; I < n; ++I)
    {
      double *K_rows = block_values[0][0] +
                       dim * dim * static_cast<std::size_t>(all_graph.row_start[cell[I]]);
      const std::size_t K_degree       = all_graph.degree(cell[I]);
      const unsigned short *row_places = &solid_places[(static_cast<std::size_t>(c) * n + I) * n];
      for (unsigned int a = 0; a < dim; ++a)
      {
        rhs_values[0][dim * cell[I] + a] -= residual[I * dim + a];
        for (unsigned int J = 0; J < n; ++J)
          for (unsigned int b = 0; b < dim; ++b)
            K_rows[dim * (a * K_degree + row_places[J]) + b] += matrix(I * dim + a, J * dim + b);
      }
    }
  }



  template <int dim>
  void BlockSystem<dim>::add_solid(const unsigned int node, const Tensor<1, dim> &residual)
  {
    solid_residuals[node] += residual;
    if (constraints[node].n_fixed == 0)
      for (unsigned int a = 0; a < dim; ++a)
        rhs_values[0][dim * node + a] -= residual[a];
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
