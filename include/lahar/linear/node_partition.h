#ifndef lahar_linear_node_partition_h
#define lahar_linear_node_partition_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <lahar/linear/nodal_graph.h>
#include <lahar/utilities/halo_exchange.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Which rank owns which of a system's nodes, and what of the system this rank works on.
   *
   * A rank knows its own nodes; the halo, the other nodes of cells that have a node of its own; the outer nodes, the
   * other nodes of cells that have a node of the halo; and all those cells. Adding up the cells that it knows gives
   * complete rows for its own nodes and for the halo, without communication.
   *
   * Local numbers: its own nodes in the order of their numbers, then the halo by owner and number, the order in which
   * Trilinos wants a matrix's columns, then the outer nodes. On one rank local numbers are the global ones.
   */
  class NodePartition
  {
  public:
    explicit NodePartition(const MPI_Comm &communicator);

    /**
     * @param owners rank of each node; if empty, each rank has an equal share of the numbers.
     * @param lists the cells, by global node numbers.
     */
    void reinit(const unsigned int n_nodes, const std::vector<unsigned int> &owners,
                const std::vector<CellList> &lists);

    const MPI_Comm &communicator() const
    {
      return mpi_communicator;
    }

    unsigned int n_own() const
    {
      return n_own_nodes;
    }

    /// Own nodes and halo.
    unsigned int n_with_rows() const
    {
      return n_row_nodes;
    }

    /// All nodes of all ranks.
    unsigned int n_nodes() const
    {
      return by_owner.size();
    }

    /// Numbers of the nodes that this rank knows.
    const std::vector<unsigned int> &nodes() const
    {
      return global_numbers;
    }

    /// Local number of a node; numbers::invalid_unsigned_int if this rank does not know it.
    unsigned int local(const unsigned int node) const
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
     * Replace the values of the known nodes of other ranks by those of their owners. @param values by local number, T
     * of doubles. Collective.
     */
    template <typename T>
    void update(std::vector<T> &values) const
    {
      AssertDimension(values.size(), global_numbers.size());
      exchange.update(reinterpret_cast<double *>(values.data()), sizeof(T) / sizeof(double));
    }

    /// Ranges of numbers: first and one beyond the last, ascending.
    using Ranges = std::vector<std::pair<unsigned int, unsigned int>>;

    /**
     * Collect on all ranks the values of the nodes in the @p ranges from their owners: @p own holds @p n_components
     * values a node by local number. @return the values in the order of the ranges. Collective.
     */
    std::vector<double> gather(const double *own, const unsigned int n_components,
                               const Ranges &ranges) const;

  private:
    void find_known(const std::vector<unsigned int> &owners, const std::vector<CellList> &lists);

    MPI_Comm mpi_communicator;
    unsigned int n_own_nodes = 0, n_row_nodes = 0;
    std::vector<unsigned int> global_numbers, local_numbers;
    std::vector<std::vector<unsigned int>> known_cells;
    std::vector<unsigned int> by_owner, first_of_rank; ///< all nodes, sorted by owner and number
    HaloExchange exchange;
  };



  /**
   * Share nodes among @p n_ranks ranks: in the order of a Hilbert curve through their positions, each rank takes a piece
   * of equal weight, which is the number of cells at the node plus one. @return the owner of each node.
   */
  template <int dim>
  std::vector<unsigned int> share_nodes(const std::vector<Point<dim>> &positions,
                                        const std::vector<CellList> &lists, const unsigned int n_ranks);
} // namespace Lahar

#endif
