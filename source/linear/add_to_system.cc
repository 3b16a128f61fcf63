// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/block_system.h>

#include <cmath>

namespace Lahar
{
  template <int dim>
  void BlockSystem<dim>::add_solid(const unsigned int k, FullMatrix<double> &matrix,
                                   dealii::Vector<double> &residual)
  {
    const unsigned int n     = nodes_per_solid_cell;
    const unsigned int *cell = &local_solid_cells[static_cast<std::size_t>(k) * n];
    for (unsigned int I = 0; I < n; ++I)
    {
      const LocalNode node(cell[I]);
      for (unsigned int a = 0; a < dim; ++a)
        solid_residuals[node][a] += residual[I * dim + a];
      Assert(constraints[node].n_fixed == 0 || constraints[node].n_fixed == dim,
             ExcMessage("A solid's node is free or has its whole velocity prescribed."));
      if (constraints[node].n_fixed == dim)
        for (unsigned int a = 0; a < dim; ++a)
        {
          const unsigned int i  = I * dim + a;
          const double diagonal = matrix(i, i);
          for (unsigned int k = 0; k < n * dim; ++k)
            matrix(i, k) = matrix(k, i) = 0.;
          matrix(i, i) = std::abs(diagonal);
          residual[i]  = 0.;
        }
    }
    for (unsigned int I = 0; I < n; ++I)
    {
      for (unsigned int a = 0; a < dim; ++a)
        velocity_diagonals[LocalNode(cell[I])][a] += matrix(I * dim + a, I * dim + a);
      if (!node_partition.is_own(LocalNode(cell[I])))
        continue;
      double *K_rows = block_values[0][0] +
                       dim * dim * static_cast<std::size_t>(all_graph.row_start[cell[I]]);
      const std::size_t K_degree       = all_graph.degree(cell[I]);
      const unsigned short *row_places = &solid_places[(static_cast<std::size_t>(k) * n + I) * n];
      for (unsigned int a = 0; a < dim; ++a)
      {
        rhs_values[0][dim * cell[I] + a] -= residual[I * dim + a];
        for (unsigned int J = 0; J < n; ++J)
          for (unsigned int b = 0; b < dim; ++b)
            K_rows[dim * (a * K_degree + row_places[J]) + b] += matrix(I * dim + a, J * dim + b);
      }
    }
  }



  template <int dim>
  void BlockSystem<dim>::add_solid(const RegionNode node, const Tensor<1, dim> &residual)
  {
    const LocalNode l = node_partition.local(node);
    if (!node_partition.is_own(l))
      return;
    solid_residuals[l] += residual;
    if (constraints[l].n_fixed == 0)
      for (unsigned int a = 0; a < dim; ++a)
        rhs_values[0][dim * l.value() + a] -= residual[a];
  }



  template <int dim>
  void BlockSystem<dim>::add_at_node(const LocalNode node, const Tensor<1, dim> &residual,
                                     const Tensor<2, dim> &by_velocity, const Tensor<1, dim> &by_pressure)
  {
    AssertIndexRange(node.value(), constraints.size());
    if (!node_partition.has_row(node))
      return;
    const NodeConstraint<dim> &constraint = constraints[node];
    const bool is_skew                    = constraint.n_fixed > 0 && constraint.n_fixed < dim;
    const Tensor<2, dim> frame = is_skew ? constraint.frame : Tensor<2, dim>(unit_symmetric_tensor<dim>());
    const Tensor<1, dim> force = frame * residual, column = frame * by_pressure;
    const Tensor<2, dim> block = frame * by_velocity * transpose(frame);

    const unsigned int l = node.value(), number = fluid_numbers[l];
    const bool own          = node_partition.is_own(node);
    const std::size_t start = pressure_graph.row_start[number] -
                              (own ? 0 : pressure_graph.row_start[n_own_pressures]),
                      degree = pressure_graph.degree(number);
    double *Q_rows           = (own ? block_values[0][1] : halo_gradient.data()) + dim * start;
    const unsigned int place = pressure_graph.place(number, number);
    for (unsigned int a = constraint.n_fixed; a < dim; ++a)
    {
      velocity_diagonals[node][a] += block[a][a];
      if (!constraint.fixed_pressure)
        Q_rows[a * degree + place] += column[a];
      if (!own)
        continue;
      rhs_values[0][dim * l + a] -= force[a];
      double *K = block_values[0][0] + dim * dim * static_cast<std::size_t>(velocity_graph().row_start[l]) +
                  dim * (a * velocity_graph().degree(l) + velocity_graph().place(l, l));
      for (unsigned int b = constraint.n_fixed; b < dim; ++b)
        K[b] += block[a][b];
    }
  }



  template <int dim>
  void BlockSystem<dim>::add_contact(const unsigned int k, const std::array<double, dim + 1> &weights,
                                     const Tensor<1, dim> &residual, const Tensor<2, dim> &by_velocity)
  {
    const unsigned int *nodes    = &local_contacts[static_cast<std::size_t>(k) * n_corners];
    const unsigned short *places = &contact_places[static_cast<std::size_t>(k) * n_corners * n_corners];
    const auto frame             = [&](const NodeConstraint<dim> &constraint) {
      return constraint.n_fixed > 0 && constraint.n_fixed < dim
                           ? constraint.frame
                           : Tensor<2, dim>(unit_symmetric_tensor<dim>());
    };
    for (unsigned int I = 0; I < n_corners; ++I)
    {
      const LocalNode node(nodes[I]);
      if (node.value() >= node_partition.n_with_rows())
        continue;
      const Tensor<2, dim> frame_I = frame(constraints[node]);
      const Tensor<1, dim> force   = weights[I] * (frame_I * residual);
      const bool own               = node_partition.is_own(node);
      for (unsigned int J = 0; J < n_corners; ++J)
      {
        const NodeConstraint<dim> &constraint_J = constraints[LocalNode(nodes[J])];
        const Tensor<2, dim> block              = weights[I] * weights[J] *
                                     (frame_I * by_velocity * transpose(frame(constraint_J)));
        for (unsigned int a = constraints[node].n_fixed; a < dim; ++a)
        {
          if (I == J)
            velocity_diagonals[node][a] += block[a][a];
          if (!own)
            continue;
          double *K = block_values[0][0] +
                      dim * dim * static_cast<std::size_t>(all_graph.row_start[node.value()]) +
                      dim * (a * all_graph.degree(node.value()) + places[I * n_corners + J]);
          for (unsigned int b = constraint_J.n_fixed; b < dim; ++b)
            K[b] += block[a][b];
        }
      }
      if (own)
        for (unsigned int a = constraints[node].n_fixed; a < dim; ++a)
          rhs_values[0][dim * node.value() + a] -= force[a];
    }
  }



  template void BlockSystem<2>::add_solid(const unsigned int, FullMatrix<double> &, dealii::Vector<double> &);
  template void BlockSystem<3>::add_solid(const unsigned int, FullMatrix<double> &, dealii::Vector<double> &);
  template void BlockSystem<2>::add_solid(const RegionNode, const Tensor<1, 2> &);
  template void BlockSystem<3>::add_solid(const RegionNode, const Tensor<1, 3> &);
  template void BlockSystem<2>::add_at_node(const LocalNode, const Tensor<1, 2> &, const Tensor<2, 2> &,
                                            const Tensor<1, 2> &);
  template void BlockSystem<3>::add_at_node(const LocalNode, const Tensor<1, 3> &, const Tensor<2, 3> &,
                                            const Tensor<1, 3> &);
  template void BlockSystem<2>::add_contact(const unsigned int, const std::array<double, 3> &,
                                            const Tensor<1, 2> &, const Tensor<2, 2> &);
  template void BlockSystem<3>::add_contact(const unsigned int, const std::array<double, 4> &,
                                            const Tensor<1, 3> &, const Tensor<2, 3> &);
} // namespace Lahar
