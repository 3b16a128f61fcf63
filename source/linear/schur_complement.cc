#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <lahar/linear/schur_complement.h>


namespace Lahar
{
  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix> make_schur_complement(const BlockSystem<dim> &system)
  {
    const unsigned int n_nodes                 = system.n_fluid_nodes();
    const NodalGraph &velocity_graph           = system.velocity_graph();
    const std::vector<unsigned int> &row_start = system.graph().row_start, &columns = system.graph().columns;
    const double *K = system.values(0, 0), *Q = system.values(0, 1), *C = system.values(1, 0),
                 *H = system.values(1, 1);

    const auto diagonal = [&](const unsigned int node, const unsigned int a) {
      const unsigned int start = velocity_graph.row_start[node], degree = velocity_graph.degree(node);
      return K[dim * dim * start + dim * (a * degree + velocity_graph.place(node, node)) + a];
    };

    const Epetra_Map rows(static_cast<int>(n_nodes), 0, system.matrix().block(0, 0).trilinos_matrix().Comm());
    auto schur = std::make_unique<Epetra_CrsMatrix>(Copy, rows, rows, 0);

    // One row after the other in a table by column.
    std::vector<int> place_in_row(n_nodes, -1), row_columns;
    std::vector<double> row;
    const auto add = [&](const unsigned int column, const double value) {
      if (place_in_row[column] < 0)
      {
        place_in_row[column] = row.size();
        row_columns.push_back(column);
        row.push_back(0.);
      }
      row[place_in_row[column]] += value;
    };
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
      {
        add(columns[k], H[k]);
        const unsigned int node = columns[k], start = row_start[node], degree = row_start[node + 1] - start;
        for (unsigned int a = 0; a < dim; ++a)
        {
          const double factor = -C[dim * k + a] / diagonal(node, a);
          if (factor != 0.)
            for (unsigned int l = 0; l < degree; ++l)
              add(columns[start + l], factor * Q[dim * start + a * degree + l]);
        }
      }
      schur->InsertGlobalValues(i, row.size(), row.data(), row_columns.data());
      for (const int column : row_columns)
        place_in_row[column] = -1;
      row.clear();
      row_columns.clear();
    }
    schur->FillComplete();
    schur->OptimizeStorage();
    return schur;
  }



  template std::unique_ptr<Epetra_CrsMatrix> make_schur_complement<2>(const BlockSystem<2> &);
  template std::unique_ptr<Epetra_CrsMatrix> make_schur_complement<3>(const BlockSystem<3> &);
} // namespace Lahar
