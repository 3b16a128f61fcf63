// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_numbering_h
#define lahar_linear_numbering_h

#include <lahar/linear/node_partition.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * The numbers of a step's nodes, and nothing else: who is who in the region's mesh, in the part that the rank works on,
   * in the system and in the solids. Velocities of vertices, nodes and solids are the same unknowns where these are the
   * same.
   */
  class Numbering
  {
  public:
    /**
     * Number the nodes that @p partition knows; it must live as long as this and stay as it is.
     * @param n_region_vertices those are the first of the region's nodes.
     * @param solids the region's node of each solid node.
     */
    void reinit(const NodePartition &partition, const unsigned int n_region_vertices,
                const IndexVector<SolidNode, RegionNode> &solids);

    /// Nodes that this rank knows; its own ones are the first.
    IndexRange<LocalNode> nodes() const
    {
      return IndexRange<LocalNode>(region_nodes.size());
    }

    IndexRange<LocalNode> own_nodes() const
    {
      return partition->own_nodes();
    }

    unsigned int n_nodes() const
    {
      return region_nodes.size();
    }

    /// Vertices among them; the own ones are the first.
    IndexRange<Vertex> vertices() const
    {
      return IndexRange<Vertex>(nodes_of_vertices.size());
    }

    IndexRange<Vertex> own_vertices() const
    {
      return IndexRange<Vertex>(n_own);
    }

    unsigned int n_own_vertices() const
    {
      return n_own;
    }

    unsigned int n_vertices() const
    {
      return nodes_of_vertices.size();
    }

    LocalNode node(const Vertex vertex) const
    {
      return nodes_of_vertices[vertex];
    }

    /// Not valid if this rank does not know it.
    LocalNode node(const RegionNode node) const
    {
      return partition->local(node);
    }

    LocalNode node(const RegionVertex vertex) const
    {
      return node(RegionNode(vertex.value()));
    }

    RegionNode region_node(const LocalNode node) const
    {
      return region_nodes[node];
    }

    RegionVertex region_vertex(const Vertex vertex) const
    {
      return RegionVertex(region_nodes[node(vertex)].value());
    }

    /// Whether a node is a vertex, and so has a pressure.
    bool is_vertex(const LocalNode node) const
    {
      return region_nodes[node].value() < n_region_vertices;
    }

    GlobalNode global_node(const LocalNode node) const
    {
      return partition->global_numbers()[node];
    }

    bool is_own(const LocalNode node) const
    {
      return partition->is_own(node);
    }

    /// The solids' nodes that this rank knows, ascending.
    const std::vector<std::pair<LocalNode, SolidNode>> &solid_nodes() const
    {
      return known_solid_nodes;
    }

    /// Values of the vertices from those of the nodes.
    template <typename T>
    IndexVector<Vertex, T> by_vertex(const IndexVector<LocalNode, T> &by_node) const
    {
      IndexVector<Vertex, T> result(n_vertices());
      for (const Vertex v : vertices())
        result[v] = by_node[node(v)];
      return result;
    }

    /// The other way round; zero at other nodes.
    template <typename T>
    IndexVector<LocalNode, T> by_node(const IndexVector<Vertex, T> &by_vertex) const
    {
      IndexVector<LocalNode, T> result(n_nodes());
      for (const Vertex v : vertices())
        result[node(v)] = by_vertex[v];
      return result;
    }

  private:
    const NodePartition *partition = nullptr;
    unsigned int n_region_vertices = 0, n_own = 0; ///< the latter: own vertices
    IndexVector<LocalNode, RegionNode> region_nodes;
    IndexVector<Vertex, LocalNode> nodes_of_vertices;
    std::vector<std::pair<LocalNode, SolidNode>> known_solid_nodes;
  };
} // namespace Lahar

#endif
