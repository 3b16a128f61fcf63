// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/numbering.h>

namespace Lahar
{
  void Numbering::reinit(const NodePartition &new_partition, const unsigned int new_n_region_vertices,
                         const IndexVector<SolidNode, RegionNode> &solids)
  {
    partition         = &new_partition;
    n_region_vertices = new_n_region_vertices;
    n_own             = 0;
    nodes_of_vertices.clear();
    known_solid_nodes.clear();
    region_nodes = partition->nodes();
    for (const LocalNode node : nodes())
      if (is_vertex(node))
      {
        nodes_of_vertices.push_back(node);
        n_own += is_own(node);
      }
    for (const SolidNode i : solids.indices())
      if (const LocalNode known = node(solids[i]); known.is_valid())
        known_solid_nodes.emplace_back(known, i);
  }
} // namespace Lahar
