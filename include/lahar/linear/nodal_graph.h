// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_nodal_graph_h
#define lahar_linear_nodal_graph_h

#include <vector>

namespace Lahar
{
  /// Cells of one kind as node numbers: those of cell c are nodes[c nodes_per_cell] … nodes[(c+1) nodes_per_cell − 1].
  struct CellList
  {
    const unsigned int *nodes   = nullptr;
    unsigned int n_cells        = 0;
    unsigned int nodes_per_cell = 0;

    const unsigned int *begin(const unsigned int cell) const
    {
      return nodes + static_cast<std::size_t>(cell) * nodes_per_cell;
    }

    const unsigned int *end(const unsigned int cell) const
    {
      return begin(cell) + nodes_per_cell;
    }
  };

  /**
   * Which nodes share a cell, themselves included: the neighbours of node i are columns[row_start[i]] …
   * columns[row_start[i+1]−1], ascending.
   */
  struct NodalGraph
  {
    std::vector<unsigned int> row_start;
    std::vector<unsigned int> columns;

    /// The graph of @p n_nodes nodes and of all the cells in the @p lists.
    void reinit(const unsigned int n_nodes, const std::vector<CellList> &lists);

    unsigned int n_rows() const
    {
      return row_start.size() - 1;
    }

    /// Number of neighbours of @p node; none for a node beyond the graph.
    unsigned int degree(const unsigned int node) const
    {
      return node < n_rows() ? row_start[node + 1] - row_start[node] : 0;
    }

    /// Place of @p neighbour, which must be one, in the row of @p node.
    unsigned int place(const unsigned int node, const unsigned int neighbour) const;
  };
} // namespace Lahar

#endif
