// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_node_partition_h
#define lahar_linear_node_partition_h

#include <deal.II/base/mpi.h>

#include <lahar/linear/nodal_graph.h>
#include <lahar/linear/node_numbers.h>
#include <lahar/utilities/halo_exchange.h>

#include <cstdint>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Which rank owns which of a system's nodes, and what of the system this rank works on.
   *
   * A rank numbers the nodes that it has heard of as it likes. Of these it works on its own nodes; the halo, the other
   * nodes of cells that have a node of its own; the outer nodes, the other nodes of cells that have a node of the halo;
   * and all those cells. These it knows. Adding up the cells that it knows gives complete rows for its own nodes and for
   * the halo, without communication.
   *
   * Local numbers: its own nodes in the order of their numbers, then the halo by owner and number, then the outer nodes.
   * Global numbers: the first rank's own nodes in that order, then those of the next one and so on. On one rank both are
   * the numbers themselves.
   */
  class NodePartition
  {
  public:
    explicit NodePartition(const MPI_Comm &communicator);

    /**
     * Collective.
     * @param owners rank of each node that this rank has heard of.
     * @param keys what identifies the node on all ranks that have heard of it, ascending.
     * @param lists the cells, by numbers of nodes: at least all those with an own node, and those with a node of these.
     * @return whether on any rank the local numbers stand for other nodes than before.
     */
    bool reinit(const std::vector<unsigned int> &owners, const std::vector<std::uint64_t> &keys,
                const std::vector<CellList> &lists);

    /// Share out @p n_nodes nodes of which all ranks have heard by the same numbers: each has an equal share of the
    /// numbers. Collective. @return as above.
    bool reinit(const unsigned int n_nodes, const std::vector<CellList> &lists);

    const MPI_Comm &communicator() const
    {
      return mpi_communicator;
    }

    unsigned int n_own() const
    {
      return n_own_nodes;
    }

    IndexRange<LocalNode> own_nodes() const
    {
      return IndexRange<LocalNode>(n_own_nodes);
    }

    bool is_own(const LocalNode node) const
    {
      return node.value() < n_own_nodes;
    }

    /// Own nodes and halo.
    unsigned int n_with_rows() const
    {
      return n_row_nodes;
    }

    /// Whether a node is an own one or one of the halo.
    bool has_row(const LocalNode node) const
    {
      return node.value() < n_row_nodes;
    }

    /// All nodes of all ranks.
    unsigned int n_nodes() const
    {
      return n_all_nodes;
    }

    /// The nodes that this rank knows.
    const IndexVector<LocalNode, RegionNode> &nodes() const
    {
      return numbers_here;
    }

    /// The same by global numbers.
    const IndexVector<LocalNode, GlobalNode> &global_numbers() const
    {
      return numbers_everywhere;
    }

    /// Not valid if this rank does not know it.
    LocalNode local(const RegionNode node) const
    {
      return local_numbers[node];
    }

    /// Numbers of the cells of a list that this rank knows, ascending.
    const std::vector<unsigned int> &cells(const unsigned int list) const
    {
      return known_cells[list];
    }

    /// The nodes of these cells by local numbers, one cell after the other.
    std::vector<unsigned int> local_cells(const unsigned int list, const CellList &cells) const;

    /**
     * Replace the values of the known nodes of other ranks by those of their owners. T is made of doubles. Collective.
     */
    template <typename T>
    void update(IndexVector<LocalNode, T> &values) const
    {
      AssertDimension(values.size(), numbers_here.size());
      exchange.update(reinterpret_cast<double *>(values.raw().data()), sizeof(T) / sizeof(double));
    }

    /// Let each rank number some of its nodes, one after the other and rank after rank: how many of all the marked nodes
    /// come before the node. What @p marked says of own nodes counts. Collective.
    IndexVector<LocalNode, unsigned int> count_before(const IndexVector<LocalNode, bool> &marked) const;

  private:
    void find_known(const std::vector<unsigned int> &owners, const std::vector<CellList> &lists);

    MPI_Comm mpi_communicator;
    unsigned int n_own_nodes = 0, n_row_nodes = 0, n_all_nodes = 0;
    IndexVector<LocalNode, RegionNode> numbers_here;
    IndexVector<LocalNode, GlobalNode> numbers_everywhere;
    IndexVector<RegionNode, LocalNode> local_numbers;
    std::vector<unsigned int> owners_here; ///< by local number
    std::vector<std::uint64_t> keys_here;  ///< by local number
    std::vector<std::vector<unsigned int>> known_cells;
    HaloExchange exchange;
  };
} // namespace Lahar

#endif
