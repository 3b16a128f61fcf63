// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/simulator/closed_parts.h>
#include <lahar/simulator/spread_largest.h>
#include <lahar/utilities/exceptions.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Area vectors cancel at nodes inside to this part of their lengths.
    constexpr double rounding = 1e-6;

    /// Normals turn by less than this in a step, rad.
    constexpr double turning = 0.1;

    /// A closed part that changes by more than this part of its volume cannot do so.
    constexpr double largest_change = 1e-6;
  } // namespace



  template <int dim>
  void ClosedParts<dim>::fix_levels(const std::vector<Simplex<dim>> &cells,
                                    const IndexVector<LocalNode, Point<dim>> &positions,
                                    const NodePartition &partition,
                                    const IndexVector<LocalNode, bool> &is_compressible,
                                    IndexVector<LocalNode, NodeConstraint<dim>> &constraints)
  {
    const unsigned int n_nodes = constraints.size();
    boost::disjoint_sets_with_storage<> parts(n_nodes);
    IndexVector<LocalNode, Tensor<1, dim>> area(n_nodes); // ∫ ∇N_I
    IndexVector<LocalNode, double> size(n_nodes, 0.);
    for (const Simplex<dim> &cell : cells)
    {
      const auto corners = corners_of<dim>(cell, positions.raw());
      const auto G       = shape_gradients<dim>(corners);
      for (unsigned int I = 0; I <= dim; ++I)
      {
        const Tensor<1, dim> share = signed_volume<dim>(corners) * G[I];
        area[LocalNode(cell[I])] += share;
        size[LocalNode(cell[I])] += share.norm();
        parts.union_set(cell[0], cell[I]);
      }
    }
    IndexVector<LocalNode, double> gives_way(n_nodes, 0.);
    for (const LocalNode i : constraints.indices())
    {
      Tensor<1, dim> free_part = area[i];
      for (unsigned int a = 0; a < constraints[i].n_fixed; ++a)
        free_part -= (free_part * constraints[i].frame[a]) * constraints[i].frame[a];
      // The frames of walls that move have their normals at the end of the step.
      const double tolerance = constraints[i].moves ? turning : rounding;
      gives_way[i]           = (constraints[i].n_fixed < dim && free_part.norm() > tolerance * size[i]) ||
                         constraints[i].fixed_pressure || is_compressible[i]
                                 ? 1.
                                 : 0.;
    }
    partition.update(gives_way);
    spread_largest(parts, partition, gives_way);

    label.assign(n_nodes, -1.);
    bool any = false;
    for (const LocalNode i : constraints.indices())
      if (gives_way[i] == 0. && size[i] > 0.)
      {
        label[i] = partition.global_numbers()[i].value();
        any      = true;
      }
    is_any = Utilities::MPI::max(any ? 1U : 0U, partition.communicator()) == 1U;
    if (!is_any)
      return;
    partition.update(label);
    spread_largest(parts, partition, label);
    for (const LocalNode i : constraints.indices())
      if (label[i] == partition.global_numbers()[i].value())
        constraints[i].fixed_pressure = true;
  }



  template <int dim>
  void ClosedParts<dim>::check(const std::vector<Simplex<dim>> &cells,
                               const IndexVector<LocalNode, Point<dim>> &positions,
                               const std::vector<double> &old_volumes, const std::vector<double> &new_volumes,
                               const NodePartition &partition) const
  {
    if (!is_any)
      return;
    // By part its volume at the start, the change, and the place of one node.
    using Sums = std::array<double, 3 + dim>;
    std::map<double, Sums> sums;
    for (unsigned int c = 0; c < cells.size(); ++c)
    {
      // A cell counts on the rank of its node with the smallest number.
      const auto &number = partition.global_numbers();
      const LocalNode node(
        *std::min_element(cells[c].begin(), cells[c].end(), [&](const unsigned int a, const unsigned int b) {
          return number[LocalNode(a)] < number[LocalNode(b)];
        }));
      if (label[node] >= 0. && partition.is_own(node))
      {
        Sums &of_part = sums.try_emplace(label[node], Sums{}).first->second;
        of_part[0]    = label[node];
        of_part[1] += old_volumes[c];
        of_part[2] += new_volumes[c] - old_volumes[c];
        for (unsigned int d = 0; d < dim; ++d)
          of_part[3 + d] = positions[node][d];
      }
    }
    std::vector<Sums> own;
    for (const auto &[number, of_part] : sums)
      own.push_back(of_part);
    std::map<double, Sums> all;
    for (const std::vector<Sums> &of_rank : Utilities::MPI::all_gather(partition.communicator(), own))
      for (const Sums &of_part : of_rank)
        if (const auto [entry, is_new] = all.try_emplace(of_part[0], of_part); !is_new)
        {
          entry->second[1] += of_part[1];
          entry->second[2] += of_part[2];
        }
    for (const auto &[number, of_part] : all)
      if (std::abs(of_part[2]) > largest_change * of_part[1])
      {
        Point<dim> place;
        for (unsigned int d = 0; d < dim; ++d)
          place[d] = of_part[3 + d];
        std::ostringstream message;
        message
          << "the fluid around (" << place
          << ") m has no free surface, and what is prescribed at its walls and solids would change its volume by "
          << 100. * of_part[2] / of_part[1] << " % in this step, which an incompressible fluid cannot follow";
        throw RunError(message.str());
      }
  }



  template class ClosedParts<2>;
  template class ClosedParts<3>;
} // namespace Lahar
