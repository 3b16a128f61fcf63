// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/nodal_graph.h>

#include <algorithm>

namespace Lahar
{
  void NodalGraph::reinit(const unsigned int n_nodes, const std::vector<CellList> &lists)
  {
    // Count, fill, sort and thin out the neighbours of every node.
    std::vector<unsigned int> start(n_nodes + 1, 0);
    for (const CellList &list : lists)
      for (const unsigned int *node = list.begin(0); node != list.begin(list.n_cells); ++node)
        start[*node + 1] += list.nodes_per_cell;
    for (unsigned int i = 0; i < n_nodes; ++i)
      start[i + 1] += start[i];
    std::vector<unsigned int> all(start[n_nodes]), end(start.begin(), start.end() - 1);
    for (const CellList &list : lists)
      for (unsigned int c = 0; c < list.n_cells; ++c)
        for (const unsigned int *node = list.begin(c); node != list.end(c); ++node)
        {
          std::copy(list.begin(c), list.end(c), all.begin() + end[*node]);
          end[*node] += list.nodes_per_cell;
        }

    row_start.assign(1, 0);
    columns.clear();
    columns.reserve(all.size() / 2);
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      std::sort(all.begin() + start[i], all.begin() + end[i]);
      columns.insert(columns.end(), all.begin() + start[i],
                     std::unique(all.begin() + start[i], all.begin() + end[i]));
      row_start.push_back(columns.size());
    }
  }



  unsigned int NodalGraph::place(const unsigned int node, const unsigned int neighbour) const
  {
    const auto begin = columns.begin() + row_start[node], end = columns.begin() + row_start[node + 1];
    return std::lower_bound(begin, end, neighbour) - begin;
  }
} // namespace Lahar
