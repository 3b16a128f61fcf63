// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/node_partition.h>

#include <algorithm>

namespace Lahar
{
  NodePartition::NodePartition(const MPI_Comm &communicator)
    : mpi_communicator(communicator)
    , exchange(communicator)
  {}



  bool NodePartition::reinit(const unsigned int n_nodes, const std::vector<CellList> &lists)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mpi_communicator);
    std::vector<unsigned int> owners;
    std::vector<std::uint64_t> keys;
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      owners.push_back(static_cast<std::size_t>(i) * n_ranks / n_nodes);
      keys.push_back(i);
    }
    return reinit(owners, keys, lists);
  }



  bool NodePartition::reinit(const std::vector<unsigned int> &owners, const std::vector<std::uint64_t> &keys,
                             const std::vector<CellList> &lists)
  {
    AssertDimension(owners.size(), keys.size());
    Assert(std::is_sorted(keys.begin(), keys.end()), ExcMessage("The keys must ascend."));
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mpi_communicator),
                       rank    = Utilities::MPI::this_mpi_process(mpi_communicator);
    const std::pair<unsigned int, unsigned int> old_counts(n_own_nodes, n_row_nodes);
    numbers_here.clear();
    for (unsigned int node = 0; node < owners.size(); ++node)
      if (owners[node] == rank)
        numbers_here.push_back(RegionNode(node));
    n_own_nodes = numbers_here.size();
    find_known(owners, lists);
    local_numbers.assign(owners.size(), LocalNode());
    for (const LocalNode l : numbers_here.indices())
      local_numbers[numbers_here[l]] = l;

    std::vector<unsigned int> new_owners, copies;
    std::vector<std::uint64_t> new_keys;
    for (const LocalNode l : numbers_here.indices())
    {
      new_owners.push_back(owners[numbers_here[l].value()]);
      new_keys.push_back(keys[numbers_here[l].value()]);
      if (!is_own(l))
        copies.push_back(l.value());
    }
    const bool changed = old_counts != std::make_pair(n_own_nodes, n_row_nodes) ||
                         new_owners != owners_here || new_keys != keys_here;
    if (Utilities::MPI::max(changed ? 1U : 0U, mpi_communicator) == 0)
      return false;
    owners_here = std::move(new_owners);
    keys_here   = std::move(new_keys);

    if (n_ranks > 1)
      exchange.reinit(copies, {owners_here.begin() + n_own_nodes, owners_here.end()},
                      {keys_here.begin() + n_own_nodes, keys_here.end()}, [&](const std::uint64_t key) {
                        const auto place = std::lower_bound(keys.begin(), keys.end(), key);
                        AssertThrow(place != keys.end() && *place == key &&
                                      owners[place - keys.begin()] == rank,
                                    ExcMessage("A rank knows a node whose owner does not."));
                        return local_numbers[RegionNode(place - keys.begin())].value();
                      });
    n_all_nodes = Utilities::MPI::sum(n_own_nodes, mpi_communicator);
    numbers_everywhere.clear();
    for (const unsigned int n_before : count_before(IndexVector<LocalNode, bool>(numbers_here.size(), true)))
      numbers_everywhere.push_back(GlobalNode(n_before));
    return true;
  }



  IndexVector<LocalNode, unsigned int>
  NodePartition::count_before(const IndexVector<LocalNode, bool> &marked) const
  {
    unsigned int n_marked = std::count(marked.begin(), marked.begin() + n_own_nodes, true), n_before = 0;
    const int ierr = MPI_Exscan(&n_marked, &n_before, 1, MPI_UNSIGNED, MPI_SUM, mpi_communicator);
    AssertThrowMPI(ierr);
    if (Utilities::MPI::this_mpi_process(mpi_communicator) == 0)
      n_before = 0; // which MPI leaves undefined
    IndexVector<LocalNode, double> counts(numbers_here.size(), 0.);
    for (const LocalNode l : own_nodes())
    {
      counts[l] = n_before;
      n_before += marked[l];
    }
    update(counts);
    return IndexVector<LocalNode, unsigned int>(std::vector<unsigned int>(counts.begin(), counts.end()));
  }



  void NodePartition::find_known(const std::vector<unsigned int> &owners, const std::vector<CellList> &lists)
  {
    std::vector<bool> known(owners.size(), false);
    for (const RegionNode node : numbers_here)
      known[node.value()] = true;
    const auto is_known = [&](const unsigned int node) { return known[node]; };

    // Twice the other nodes of the cells with a known node: the halo, then the outer nodes.
    for (unsigned int layer = 0; layer < 2; ++layer)
    {
      known_cells.assign(lists.size(), {});
      std::vector<unsigned int> added;
      for (unsigned int k = 0; k < lists.size(); ++k)
        for (unsigned int c = 0; c < lists[k].n_cells; ++c)
          if (std::any_of(lists[k].begin(c), lists[k].end(c), is_known))
          {
            known_cells[k].push_back(c);
            std::copy_if(lists[k].begin(c), lists[k].end(c), std::back_inserter(added),
                         [&](const unsigned int node) { return !known[node]; });
          }
      std::sort(added.begin(), added.end(), [&](const unsigned int i, const unsigned int j) {
        return std::make_pair(owners[i], i) < std::make_pair(owners[j], j);
      });
      added.erase(std::unique(added.begin(), added.end()), added.end());
      for (const unsigned int node : added)
      {
        known[node] = true;
        numbers_here.push_back(RegionNode(node));
      }
      if (layer == 0)
        n_row_nodes = numbers_here.size();
    }
  }



  std::vector<unsigned int> NodePartition::local_cells(const unsigned int list, const CellList &cells) const
  {
    std::vector<unsigned int> result;
    result.reserve(known_cells[list].size() * cells.nodes_per_cell);
    for (const unsigned int c : known_cells[list])
      for (const unsigned int *node = cells.begin(c); node != cells.end(c); ++node)
        result.push_back(local_numbers[RegionNode(*node)].value());
    return result;
  }
} // namespace Lahar
