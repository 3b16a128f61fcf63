// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/undetermined_pressures.h>

#include <boost/pending/disjoint_sets.hpp>

namespace Lahar
{
  template <int dim>
  void fix_undetermined_pressures(const std::vector<Simplex<dim>> &cells, const NodePartition &partition,
                                  IndexVector<LocalNode, NodeConstraint<dim>> &constraints)
  {
    const unsigned int n_nodes = constraints.size();
    boost::disjoint_sets_with_storage<> parts(n_nodes);
    for (const Simplex<dim> &cell : cells)
      for (unsigned int I = 1; I <= dim; ++I)
        parts.union_set(cell[0], cell[I]);

    // By node whether its part can move. The parts of different ranks join at nodes that both know: go on until all
    // have heard of it.
    IndexVector<LocalNode, double> moves(n_nodes, 0.);
    for (const LocalNode i : constraints.indices())
      moves[i] = constraints[i].n_fixed < dim ? 1. : 0.;
    for (bool any_news = true; any_news;)
    {
      std::vector<bool> part_moves(n_nodes, false);
      for (const LocalNode i : constraints.indices())
        if (moves[i] > 0.)
          part_moves[parts.find_set(i.value())] = true;
      bool own_news = false;
      for (const LocalNode i : constraints.indices())
        if (part_moves[parts.find_set(i.value())] && moves[i] == 0.)
        {
          moves[i] = 1.;
          own_news = own_news || partition.is_own(i);
        }
      any_news = Utilities::MPI::max(own_news ? 1U : 0U, partition.communicator()) == 1U;
      if (any_news)
        partition.update(moves);
    }
    for (const LocalNode i : constraints.indices())
      constraints[i].fixed_pressure = (moves[i] == 0.);
  }



  template void fix_undetermined_pressures(const std::vector<Simplex<2>> &, const NodePartition &,
                                           IndexVector<LocalNode, NodeConstraint<2>> &);
  template void fix_undetermined_pressures(const std::vector<Simplex<3>> &, const NodePartition &,
                                           IndexVector<LocalNode, NodeConstraint<3>> &);
} // namespace Lahar
