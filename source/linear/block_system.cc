// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/block_system.h>
#include <lahar/linear/nodal_matrix.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  BlockSystem<dim>::BlockSystem(const MPI_Comm &communicator)
    : node_partition(communicator)
  {}



  namespace
  {
    /// The places of all pairs of nodes of all cells in the rows of a graph.
    void find_places(const NodalGraph &graph, const CellList &list, std::vector<unsigned short> &places)
    {
      for (unsigned int c = 0; c < list.n_cells; ++c)
        for (const unsigned int *I = list.begin(c); I != list.end(c); ++I)
          for (const unsigned int *J = list.begin(c); J != list.end(c); ++J)
            places.push_back(graph.place(*I, *J));
    }

    template <typename Cell, typename Places>
    void find_places(const NodalGraph &graph, const std::vector<Cell> &cells, Places &places)
    {
      places.resize(cells.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (unsigned int I = 0; I < cells[c].size(); ++I)
          for (unsigned int J = 0; J < cells[c].size(); ++J)
            places[c][I * cells[c].size() + J] = graph.place(cells[c][I], cells[c][J]);
    }
  } // namespace



  template <int dim>
  void BlockSystem<dim>::reinit(const unsigned int new_n_fluid_nodes, const std::vector<Cell> &cells,
                                const SolidPart &solids, const IndexVector<RegionNode, Point<dim>> &positions,
                                const NodeIdentities &identities)
  {
    const unsigned int n_nodes       = new_n_fluid_nodes + solids.n_nodes,
                       n_solid_cells = solids.cells.empty() ? 0 : solids.cells.size() / solids.nodes_per_cell;
    Assert(positions.size() == n_nodes || (positions.empty() && n_solid_cells == 0),
           ExcDimensionMismatch(positions.size(), n_nodes));
    n_fluid_nodes = new_n_fluid_nodes;

    const std::vector<CellList> lists = {
      {cells.empty() ? nullptr : cells.front().data(), static_cast<unsigned int>(cells.size()), n_corners},
      {solids.cells.data(), n_solid_cells, solids.nodes_per_cell},
      {solids.contacts.data(), static_cast<unsigned int>(solids.contacts.size() / n_corners), n_corners}};
    const bool nodes_change = identities.owners.empty()
                                ? node_partition.reinit(n_nodes, lists)
                                : node_partition.reinit(identities.owners, identities.keys, lists);
    own_positions.resize(positions.empty() ? 0 : node_partition.n_own());
    set_positions(positions);

    const std::vector<unsigned int> flat_cells = node_partition.local_cells(0, lists[0]);
    std::vector<Cell> new_cells(flat_cells.size() / n_corners);
    for (unsigned int k = 0; k < new_cells.size(); ++k)
      std::copy_n(flat_cells.begin() + k * n_corners, n_corners, new_cells[k].begin());
    std::vector<unsigned int> new_solid_cells = node_partition.local_cells(1, lists[1]),
                              new_contacts    = node_partition.local_cells(2, lists[2]);
    constraints.assign(node_partition.nodes().size(), NodeConstraint<dim>());
    bool changed = n_patterns == 0 || nodes_change || solids.nodes_per_cell != nodes_per_solid_cell ||
                   new_cells != local_cells || new_solid_cells != local_solid_cells ||
                   new_contacts != local_contacts;
    for (const LocalNode l : constraints.indices())
      changed = changed || is_fluid(l) != (node_partition.nodes()[l].value() < n_fluid_nodes);
    if (Utilities::MPI::max(changed ? 1U : 0U, node_partition.communicator()) == 0)
      return;

    ++n_patterns;
    nodes_per_solid_cell = solids.nodes_per_cell;
    local_cells          = std::move(new_cells);
    local_solid_cells    = std::move(new_solid_cells);
    local_contacts       = std::move(new_contacts);
    number_unknowns();
    make_matrices();
    rhs = make_vector();
    for (unsigned int b = 0; b < 2; ++b)
      rhs_values[b] = rhs.block(b).begin();
    for (auto *values : {&residuals, &solid_residuals, &velocity_diagonals})
      values->assign(node_partition.nodes().size(), Tensor<1, dim>());
  }



  template <int dim>
  void BlockSystem<dim>::set_positions(const IndexVector<RegionNode, Point<dim>> &positions)
  {
    for (unsigned int l = 0; l < own_positions.size(); ++l)
      own_positions[l] = positions[node_partition.nodes()[LocalNode(l)]];
  }



  template <int dim>
  void BlockSystem<dim>::number_unknowns()
  {
    const IndexVector<LocalNode, RegionNode> &nodes = node_partition.nodes();
    fluid_numbers.assign(1, 0);
    local_numbers.clear();
    IndexVector<LocalNode, bool> has_pressure;
    for (const LocalNode l : nodes.indices())
    {
      has_pressure.push_back(nodes[l].value() < n_fluid_nodes);
      if (has_pressure[l])
        local_numbers.push_back(l);
      fluid_numbers.push_back(local_numbers.size());
    }
    n_own_pressures    = fluid_numbers[node_partition.n_own()];
    n_pressures_before = node_partition.count_before(has_pressure);

    std::vector<Cell> numbered_cells = local_cells;
    for (Cell &cell : numbered_cells)
      for (unsigned int &node : cell)
        node = fluid_numbers[node];
    const auto list_of = [](const std::vector<Cell> &cells) {
      return CellList{cells.empty() ? nullptr : cells.front().data(), static_cast<unsigned int>(cells.size()),
                      n_corners};
    };
    pressure_graph.reinit(local_numbers.size(), {list_of(numbered_cells)});
    find_places(pressure_graph, numbered_cells, places);
    all_graph = NodalGraph();
    velocity_places.clear();
    solid_places.clear();
    contact_places.clear();
    if (nodes_per_solid_cell == 0)
      return;
    const CellList solid_list{local_solid_cells.data(),
                              static_cast<unsigned int>(local_solid_cells.size() / nodes_per_solid_cell),
                              nodes_per_solid_cell},
      contact_list{local_contacts.data(), static_cast<unsigned int>(local_contacts.size() / n_corners),
                   n_corners};
    all_graph.reinit(nodes.size(), {list_of(local_cells), solid_list, contact_list});
    find_places(all_graph, local_cells, velocity_places);
    find_places(all_graph, solid_list, solid_places);
    find_places(all_graph, contact_list, contact_places);
  }



  template <int dim>
  void BlockSystem<dim>::make_matrices()
  {
    const unsigned int n_own = node_partition.n_own(), n_rows = node_partition.n_with_rows();
    std::vector<unsigned int> velocities, pressures;
    for (const GlobalNode node : node_partition.global_numbers())
      velocities.push_back(node.value());
    for (const LocalNode l : local_numbers)
      pressures.push_back(n_pressures_before[l]);
    const NodalUnknowns unknowns[2] = {{velocities, n_own, n_rows, dim},
                                       {pressures, n_own_pressures, fluid_numbers[n_rows], 1}};
    block_matrix.reinit(2, 2);
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < 2; ++column)
      {
        make_nodal_matrix(row == 0 && column == 0 ? velocity_graph() : pressure_graph, unknowns[row],
                          unknowns[column], node_partition.communicator(), block_matrix.block(row, column));
        block_values[row][column] = values_of(block_matrix.block(row, column));
      }
    block_matrix.collect_sizes();
    halo_gradient.resize(
      dim * (pressure_graph.row_start[fluid_numbers[n_rows]] - pressure_graph.row_start[n_own_pressures]));
  }



  template <int dim>
  typename BlockSystem<dim>::Vector BlockSystem<dim>::make_vector() const
  {
    const unsigned int n_own = node_partition.n_own();
    IndexSet velocities(dim * n_nodes()),
      pressures(Utilities::MPI::sum(n_own_pressures, node_partition.communicator()));
    if (n_own > 0)
    {
      const unsigned int first = node_partition.global_numbers()[LocalNode(0)].value();
      velocities.add_range(dim * first, dim * (first + n_own));
    }
    if (n_own_pressures > 0)
    {
      const unsigned int first = n_pressures_before[local_numbers[Vertex(0)]];
      pressures.add_range(first, first + n_own_pressures);
    }
    return Vector({velocities, pressures}, node_partition.communicator());
  }



  template <int dim>
  void BlockSystem<dim>::set_constraints(const IndexVector<LocalNode, NodeConstraint<dim>> &new_constraints)
  {
    AssertDimension(new_constraints.size(), node_partition.nodes().size());
    constraints = new_constraints;
  }



  template <int dim>
  void BlockSystem<dim>::set_zero()
  {
    const std::size_t components[2] = {dim, 1};
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < 2; ++column)
      {
        const std::size_t n_entries = (row == 0 && column == 0
                                         ? velocity_graph().row_start[node_partition.n_own()]
                                         : pressure_graph.row_start[n_own_pressures]);
        std::fill_n(block_values[row][column], n_entries * components[row] * components[column], 0.);
      }
    std::fill(halo_gradient.begin(), halo_gradient.end(), 0.);
    rhs = 0.;
    for (auto *values : {&residuals, &solid_residuals, &velocity_diagonals})
      std::fill(values->raw().begin(), values->raw().end(), Tensor<1, dim>());
  }



  template <int dim>
  void BlockSystem<dim>::add(const unsigned int k, const LocalMatrix<dim> &matrix,
                             const LocalVector<dim> &residual)
  {
    const Cell &cell = local_cells[k];
    for (unsigned int I = 0; I < n_corners; ++I)
      for (unsigned int a = 0; a < dim; ++a)
        residuals[LocalNode(cell[I])][a] += residual[I * n_corners + a];

    std::array<const NodeConstraint<dim> *, n_corners> corner_constraints;
    for (unsigned int I = 0; I < n_corners; ++I)
      corner_constraints[I] = &constraints[LocalNode(cell[I])];
    auto local_matrix   = matrix;
    auto local_residual = residual;
    eliminate_prescribed<dim>(corner_constraints, local_matrix, local_residual);

    for (unsigned int I = 0; I < n_corners; ++I)
    {
      const unsigned int node = cell[I], number = fluid_numbers[node];
      if (node >= node_partition.n_with_rows())
        continue;
      for (unsigned int a = 0; a < dim; ++a)
        velocity_diagonals[LocalNode(node)][a] += local_matrix[I * n_corners + a][I * n_corners + a];
      const bool own          = node < node_partition.n_own();
      const std::size_t start = pressure_graph.row_start[number] -
                                (own ? 0 : pressure_graph.row_start[n_own_pressures]),
                        degree = pressure_graph.degree(number);
      double *Q_rows           = (own ? block_values[0][1] : halo_gradient.data()) + dim * start;
      for (unsigned int J = 0; J < n_corners; ++J)
        for (unsigned int a = 0; a < dim; ++a)
          Q_rows[a * degree + places[k][I * n_corners + J]] +=
            local_matrix[I * n_corners + a][J * n_corners + dim];
      if (!own)
        continue;

      double *K_rows = block_values[0][0] +
                       dim * dim * static_cast<std::size_t>(velocity_graph().row_start[node]);
      const std::size_t K_degree = velocity_graph().degree(node);
      for (unsigned int a = 0; a < dim; ++a)
        rhs_values[0][dim * node + a] -= local_residual[I * n_corners + a];
      rhs_values[1][number] -= local_residual[I * n_corners + dim];

      for (unsigned int J = 0; J < n_corners; ++J)
      {
        const unsigned int place   = places[k][I * n_corners + J],
                           K_place = (has_solids() ? velocity_places : places)[k][I * n_corners + J];
        for (unsigned int a = 0; a < dim; ++a)
        {
          const double *row = &local_matrix[I * n_corners + a][J * n_corners];
          double *K         = K_rows + dim * (a * K_degree + K_place);
          for (unsigned int b = 0; b < dim; ++b)
            K[b] += row[b];
        }
        const double *row = &local_matrix[I * n_corners + dim][J * n_corners];
        for (unsigned int b = 0; b < dim; ++b)
          block_values[1][0][dim * (start + place) + b] += row[b];
        block_values[1][1][start + place] += row[dim];
      }
    }
  }



  template <int dim>
  const Tensor<1, dim> &BlockSystem<dim>::velocity_diagonal(const LocalNode node) const
  {
    AssertIndexRange(node.value(), node_partition.n_with_rows());
    return velocity_diagonals[node];
  }



  template <int dim>
  const double *BlockSystem<dim>::gradient_row(const Vertex fluid_number, const unsigned int a) const
  {
    const unsigned int number = fluid_number.value();
    const std::size_t start = pressure_graph.row_start[number], degree = pressure_graph.degree(number),
                      own = pressure_graph.row_start[n_own_pressures];
    return (number < n_own_pressures ? block_values[0][1] + dim * start
                                     : halo_gradient.data() + dim * (start - own)) +
           a * degree;
  }



  template <int dim>
  IndexVector<LocalNode, Tensor<1, dim>> BlockSystem<dim>::velocities(const Vector &solution) const
  {
    IndexVector<LocalNode, Tensor<1, dim>> result(node_partition.nodes().size());
    const double *value = solution.block(0).begin();
    for (const LocalNode l : node_partition.own_nodes())
    {
      for (unsigned int a = 0; a < dim; ++a, ++value)
        if (a >= constraints[l].n_fixed) // an iterative solver leaves an error there
          result[l][a] = *value;
      if (constraints[l].n_fixed > 0 && constraints[l].n_fixed < dim)
        result[l] = transpose(constraints[l].frame) * result[l];
    }
    node_partition.update(result);
    return result;
  }



  template <int dim>
  IndexVector<Vertex, double> BlockSystem<dim>::pressures(const Vector &solution) const
  {
    IndexVector<LocalNode, double> by_node(node_partition.nodes().size(), 0.);
    IndexVector<Vertex, double> result;
    const double *value = solution.block(1).begin();
    for (const Vertex number : IndexRange<Vertex>(n_own_pressures))
      by_node[local_numbers[number]] = value[number.value()];
    node_partition.update(by_node);
    for (const LocalNode l : local_numbers)
      result.push_back(by_node[l]);
    return result;
  }



  template class BlockSystem<2>;
  template class BlockSystem<3>;
} // namespace Lahar
