// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_nodal_matrix_h
#define lahar_linear_nodal_matrix_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <lahar/linear/nodal_graph.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// Nodes of one side of a matrix, rows or columns, with the number of unknowns that each has.
  struct NodalUnknowns
  {
    const std::vector<unsigned int> &nodes; ///< global numbers by local number
    unsigned int n_own;                     ///< the first ones are this rank's
    unsigned int n_columns;                 ///< these may appear as columns
    unsigned int n_components;

    /// Global numbers of the unknowns of the first @p n nodes: those of node i start at i #n_components.
    std::vector<int> global_unknowns(const unsigned int n) const;
  };

  /**
   * Make a Trilinos matrix in which a row has the columns that a nodal graph (in local numbers) says, in its order;
   * nodes beyond the graph have empty rows. Collective.
   */
  void make_nodal_matrix(const NodalGraph &graph, const NodalUnknowns &rows, const NodalUnknowns &columns,
                         const MPI_Comm &communicator, TrilinosWrappers::SparseMatrix &matrix);

  /// The values of a matrix of this rank's rows, one row after the other.
  double *values_of(const TrilinosWrappers::SparseMatrix &matrix);
} // namespace Lahar

#endif
