// SPDX-License-Identifier: GPL-3.0-or-later

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <lahar/linear/schur_complement.h>


namespace Lahar
{
  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix> make_schur_complement(const BlockSystem<dim> &system)
  {
    const std::vector<unsigned int> &row_start = system.graph().row_start, &columns = system.graph().columns;
    const double *C = system.values(1, 0), *H = system.values(1, 1);

    std::vector<int> global_numbers;
    for (const Vertex number : IndexRange<Vertex>(system.graph().n_rows()))
      global_numbers.push_back(system.pressures_before()[system.local_number(number)]);
    const Epetra_Map rows(-1, static_cast<int>(system.n_own_fluid_nodes()), global_numbers.data(), 0,
                          system.matrix().block(0, 0).trilinos_matrix().Comm());
    auto schur = std::make_unique<Epetra_CrsMatrix>(Copy, rows, 0);

    // One row after the other in a table by column.
    std::vector<int> place_in_row(global_numbers.size(), -1), row_columns, row_numbers;
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
    for (unsigned int i = 0; i < system.n_own_fluid_nodes(); ++i)
    {
      for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
      {
        add(columns[k], H[k]);
        const unsigned int node = columns[k], start = row_start[node], degree = row_start[node + 1] - start;
        const Tensor<1, dim> &diagonal = system.velocity_diagonal(system.local_number(Vertex(node)));
        for (unsigned int a = 0; a < dim; ++a)
        {
          const double factor = -C[dim * k + a] / diagonal[a];
          const double *Q     = system.gradient_row(Vertex(node), a);
          if (factor != 0.)
            for (unsigned int l = 0; l < degree; ++l)
              add(columns[start + l], factor * Q[l]);
        }
      }
      for (const int column : row_columns)
        row_numbers.push_back(global_numbers[column]);
      schur->InsertGlobalValues(global_numbers[i], row.size(), row.data(), row_numbers.data());
      row_numbers.clear();
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
