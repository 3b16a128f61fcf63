// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_block_system_h
#define lahar_linear_block_system_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>
#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/vector.h>

#include <lahar/linear/node_constraint.h>
#include <lahar/linear/node_partition.h>

#include <array>
#include <cstdint>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// The solids' part of a system.
  struct SolidPart
  {
    unsigned int n_nodes = 0;        ///< that are none of the fluid's
    std::vector<unsigned int> cells; ///< node numbers, one cell after the other
    unsigned int nodes_per_cell = 0;
    /// Contacts: a node of the fluid and the dim nodes of the facet of a solid along which it slides.
    std::vector<unsigned int> contacts;
  };

  /// What the nodes are on all ranks, see NodePartition::reinit(). Without owners all ranks have the whole mesh.
  struct NodeIdentities
  {
    std::vector<unsigned int> owners;
    std::vector<std::uint64_t> keys;
  };

  /**
   * The Trilinos block system of one nonlinear iteration,
   *
   *   [ K   Q ] [δv]     [ R_v ]
   *   [ C   H ] [δp] = − [ R_p ],
   *
   * C = −Qᵀ but for stabilisation, geometry and stress that depends on the pressure. Velocity component a of node i is
   * unknown dim i + a of block 0, its pressure unknown i of block 1. In all four blocks the columns of a row follow a
   * nodal graph, so the place of an entry is computed, not searched for: add() costs one table lookup per pair of nodes.
   *
   * The fluid's nodes come first. Nodes of solids that are none of the fluid's follow, and have no pressure; where the
   * two share a node, K is the sum of both; where fluid slides along a solid, contacts join a node of the fluid and those
   * of a facet. K follows velocity_graph(), which has all of these, the other blocks follow graph(), which has the fluid's
   * cells.
   *
   * Each rank has the rows of its own nodes, see NodePartition, and assembles all cells that it knows. The graphs are in
   * local numbers; a fluid node's row in graph() and its place as a column there is fluid_number() of its local number,
   * which counts the known nodes of the fluid before it.
   *
   * Prescribed components are eliminated while cells are added: their rows and columns stay empty but for the diagonal,
   * their right-hand side is zero (increments keep prescribed values). Nodes with a skew frame have their unknowns in
   * it.
   */
  template <int dim>
  class BlockSystem
  {
  public:
    static constexpr unsigned int n_corners = dim + 1;
    using Cell                              = std::array<unsigned int, n_corners>;
    using Vector                            = TrilinosWrappers::MPI::BlockVector;

    explicit BlockSystem(const MPI_Comm &communicator);

    /**
     * Number the unknowns and make the matrices for a new fluid mesh of @p cells with @p n_fluid_nodes nodes, and for
     * the @p solids, which need the nodes' @p positions. Where, on all ranks, the same cells join the same nodes as
     * before, the matrices stay. Collective.
     * @param identities without owners each rank has an equal share of the nodes' numbers.
     */
    void reinit(const unsigned int n_fluid_nodes, const std::vector<Cell> &cells,
                const SolidPart &solids = {}, const IndexVector<RegionNode, Point<dim>> &positions = {},
                const NodeIdentities &identities = {});

    /// Numbers of the fluid's cells that this rank adds, ascending.
    const std::vector<unsigned int> &cells() const
    {
      return node_partition.cells(0);
    }

    /// The same of the solids' cells.
    const std::vector<unsigned int> &solid_cells() const
    {
      return node_partition.cells(1);
    }

    /// The same of the contacts.
    const std::vector<unsigned int> &contacts() const
    {
      return node_partition.cells(2);
    }

    /// Tell where the nodes are now, if they were told to reinit().
    void set_positions(const IndexVector<RegionNode, Point<dim>> &positions);

    /// The fluid's cells that this rank adds, by local numbers of nodes.
    const std::vector<Cell> &cells_by_local_number() const
    {
      return local_cells;
    }

    /// Set what is prescribed, one entry for each node that this rank knows.
    void set_constraints(const IndexVector<LocalNode, NodeConstraint<dim>> &constraints);

    /// Clear matrix, right-hand side and reactions.
    void set_zero();

    /**
     * Add matrix and residual of cell cells()[@p k]. Local unknown (I, component) has the index I (dim+1) + component,
     * component dim is the pressure.
     */
    void add(const unsigned int k, const LocalMatrix<dim> &matrix, const LocalVector<dim> &residual);

    /**
     * Add @p matrix and @p residual of solid cell solid_cells()[@p k]; local unknown (I, component) has the index
     * I dim + component. The nodes of solids have none or all of their components prescribed; those are eliminated in the
     * arguments, too.
     */
    void add_solid(const unsigned int k, FullMatrix<double> &matrix, dealii::Vector<double> &residual);

    /// Add a force of a node, to residual and solid_residual(). All ranks call it for all nodes that have such.
    void add_solid(const RegionNode node, const Tensor<1, dim> &residual);

    /**
     * Add a force on a node of the fluid that is no cell's: @p residual, its derivatives with respect to the node's
     * velocity and its derivative with respect to the node's pressure. It is no part of momentum_residual().
     */
    void add_at_node(const LocalNode node, const Tensor<1, dim> &residual, const Tensor<2, dim> &by_velocity,
                     const Tensor<1, dim> &by_pressure);

    /**
     * Add the force of contact contacts()[@p k], whose velocity is the sum of those of its nodes, each with its weight:
     * @p residual and its derivatives with respect to that velocity. It is no part of momentum_residual() or
     * solid_residual().
     */
    void add_contact(const unsigned int k, const std::array<double, dim + 1> &weights,
                     const Tensor<1, dim> &residual, const Tensor<2, dim> &by_velocity);

    /// All nodes.
    unsigned int n_nodes() const
    {
      return node_partition.n_nodes();
    }

    /// Whether a node has a pressure.
    bool is_fluid(const LocalNode node) const
    {
      return fluid_numbers[node.value()] < fluid_numbers[node.value() + 1];
    }

    /// How many pressures of all ranks come before that of a node; of one without pressure, before those of the nodes
    /// after it.
    const IndexVector<LocalNode, unsigned int> &pressures_before() const
    {
      return n_pressures_before;
    }

    /// Whether some cells are those of solids.
    bool has_solids() const
    {
      return nodes_per_solid_cell > 0;
    }

    /// Where this rank's own nodes are by reinit() or set_positions(); empty if that was not told.
    const std::vector<Point<dim>> &positions() const
    {
      return own_positions;
    }

    /// The nodes of this rank.
    const NodePartition &partition() const
    {
      return node_partition;
    }

    /// Own nodes with a pressure: the first ones.
    unsigned int n_own_fluid_nodes() const
    {
      return n_own_pressures;
    }

    /// The number of the fluid's nodes before a node, which is that of the node itself if it has a pressure.
    Vertex fluid_number(const LocalNode node) const
    {
      return Vertex(fluid_numbers[node.value()]);
    }

    /// Local number of a node of the fluid from its fluid_number().
    LocalNode local_number(const Vertex fluid_number) const
    {
      return local_numbers[fluid_number];
    }

    const NodalGraph &graph() const
    {
      return pressure_graph;
    }

    /// Neighbours by cells of all kinds; without solids the same as graph().
    const NodalGraph &velocity_graph() const
    {
      return has_solids() ? all_graph : pressure_graph;
    }

    /// Counts the changes of the matrices' pattern: solvers keep what belongs to one.
    unsigned int pattern_number() const
    {
      return n_patterns;
    }

    const TrilinosWrappers::BlockSparseMatrix &matrix() const
    {
      return block_matrix;
    }

    /// Values of this rank's rows of block (@p row, @p column) in the order of the block's graph.
    const double *values(const unsigned int row, const unsigned int column) const
    {
      return block_values[row][column];
    }

    /// diag(K) of an own node or one of the halo.
    const Tensor<1, dim> &velocity_diagonal(const LocalNode node) const;

    /// Row of component @p a of a fluid's node, own or of the halo, in Q.
    const double *gradient_row(const Vertex fluid_number, const unsigned int a) const;

    const Vector &right_hand_side() const
    {
      return rhs;
    }

    /// A vector of the system's layout, zero.
    Vector make_vector() const;

    /// Velocity increments of the known nodes from the vector of unknowns; prescribed components are zero, whatever a
    /// solver left there. Collective.
    IndexVector<LocalNode, Tensor<1, dim>> velocities(const Vector &solution) const;

    /// Pressure increments of the known nodes of the fluid. Collective.
    IndexVector<Vertex, double> pressures(const Vector &solution) const;

    /**
     * Sum over the fluid's cells of the momentum residual, whole for own nodes, prescribed components included, N: where
     * the velocity is prescribed or shared it is the force of the wall or of the solid on the fluid.
     */
    const IndexVector<LocalNode, Tensor<1, dim>> &momentum_residual() const
    {
      return residuals;
    }

    /// The same for the solids' cells.
    const IndexVector<LocalNode, Tensor<1, dim>> &solid_residual() const
    {
      return solid_residuals;
    }

  private:
    void number_unknowns();
    void make_matrices();

    NodePartition node_partition;
    std::vector<Point<dim>> own_positions;
    unsigned int n_fluid_nodes = 0, n_own_pressures = 0;
    std::vector<unsigned int> fluid_numbers; ///< before each local number and before one beyond the last
    IndexVector<Vertex, LocalNode> local_numbers;
    IndexVector<LocalNode, unsigned int> n_pressures_before;

    using Places = std::vector<std::array<unsigned short, n_corners * n_corners>>;

    std::vector<Cell> local_cells; ///< by local numbers
    std::vector<unsigned int> local_solid_cells, local_contacts;
    unsigned int nodes_per_solid_cell = 0;
    NodalGraph pressure_graph, all_graph; ///< the latter with solids only
    Places places, velocity_places;       ///< of node J in the row of node I of the two graphs, by cell
    std::vector<unsigned short> solid_places, contact_places;
    unsigned int n_patterns = 0;

    IndexVector<LocalNode, NodeConstraint<dim>> constraints;

    TrilinosWrappers::BlockSparseMatrix block_matrix;
    Vector rhs;
    std::array<std::array<double *, 2>, 2> block_values = {};
    std::array<double *, 2> rhs_values                  = {};
    std::vector<double> halo_gradient; ///< Q's rows of the halo, as those of this rank
    IndexVector<LocalNode, Tensor<1, dim>> velocity_diagonals; ///< of own nodes and the halo
    IndexVector<LocalNode, Tensor<1, dim>> residuals, solid_residuals;
  };
} // namespace Lahar

#endif
