// SPDX-License-Identifier: GPL-3.0-or-later

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <lahar/linear/nodal_matrix.h>

namespace Lahar
{
  std::vector<int> NodalUnknowns::global_unknowns(const unsigned int n) const
  {
    std::vector<int> result;
    result.reserve(n * n_components);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int a = 0; a < n_components; ++a)
        result.push_back(nodes[i] * n_components + a);
    return result;
  }



  void make_nodal_matrix(const NodalGraph &graph, const NodalUnknowns &rows, const NodalUnknowns &columns,
                         const MPI_Comm &communicator, TrilinosWrappers::SparseMatrix &matrix)
  {
    const Epetra_MpiComm epetra_communicator(communicator);
    const auto make_map = [&](const std::vector<int> &unknowns) {
      return Epetra_Map(-1, static_cast<int>(unknowns.size()), unknowns.data(), 0, epetra_communicator);
    };
    const Epetra_Map row_map    = make_map(rows.global_unknowns(rows.n_own)),
                     domain_map = make_map(columns.global_unknowns(columns.n_own)),
                     column_map = make_map(columns.global_unknowns(columns.n_columns));

    std::vector<int> row_lengths;
    for (unsigned int i = 0; i < rows.n_own; ++i)
      row_lengths.insert(row_lengths.end(), rows.n_components,
                         static_cast<int>(graph.degree(i) * columns.n_components));

    Epetra_CrsGraph crs_graph(Copy, row_map, column_map, row_lengths.data(), true);
    std::vector<int> indices;
    for (unsigned int i = 0; i < rows.n_own && i < graph.n_rows(); ++i)
    {
      indices.clear();
      for (unsigned int k = graph.row_start[i]; k < graph.row_start[i + 1]; ++k)
        for (unsigned int b = 0; b < columns.n_components; ++b)
          indices.push_back(graph.columns[k] * columns.n_components + b);
      for (unsigned int a = 0; a < rows.n_components; ++a)
        crs_graph.InsertMyIndices(i * rows.n_components + a, indices.size(), indices.data());
    }
    crs_graph.FillComplete(domain_map, row_map);
    crs_graph.OptimizeStorage();

    Epetra_CrsMatrix crs_matrix(Copy, crs_graph);
    crs_matrix.FillComplete(domain_map, row_map);
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
} // namespace Lahar
