#include <deal.II/base/utilities.h>

#include <lahar/linear/node_partition.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace Lahar
{
  NodePartition::NodePartition(const MPI_Comm &communicator)
    : mpi_communicator(communicator)
    , exchange(communicator)
  {}



  void NodePartition::reinit(const unsigned int n_nodes, const std::vector<unsigned int> &given_owners,
                             const std::vector<CellList> &lists)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mpi_communicator),
                       rank    = Utilities::MPI::this_mpi_process(mpi_communicator);

    std::vector<unsigned int> owners = given_owners;
    if (owners.empty())
      for (unsigned int i = 0; i < n_nodes; ++i)
        owners.push_back(static_cast<std::size_t>(i) * n_ranks / n_nodes);
    AssertDimension(owners.size(), n_nodes);

    by_owner.resize(n_nodes);
    std::iota(by_owner.begin(), by_owner.end(), 0U);
    std::stable_sort(by_owner.begin(), by_owner.end(),
                     [&](const unsigned int i, const unsigned int j) { return owners[i] < owners[j]; });
    first_of_rank.assign(n_ranks + 1, 0);
    for (const unsigned int owner : owners)
      ++first_of_rank[owner + 1];
    std::partial_sum(first_of_rank.begin(), first_of_rank.end(), first_of_rank.begin());

    global_numbers.assign(by_owner.begin() + first_of_rank[rank], by_owner.begin() + first_of_rank[rank + 1]);
    n_own_nodes = global_numbers.size();
    find_known(owners, lists);
    local_numbers.assign(n_nodes, numbers::invalid_unsigned_int);
    for (unsigned int l = 0; l < global_numbers.size(); ++l)
      local_numbers[global_numbers[l]] = l;

    // An owner's local number of a node is the node's place among all that it owns.
    std::vector<unsigned int> halo_owners, halo_numbers;
    for (unsigned int l = n_own_nodes; l < global_numbers.size(); ++l)
    {
      const unsigned int owner = owners[global_numbers[l]];
      const auto first         = by_owner.begin() + first_of_rank[owner];
      halo_owners.push_back(owner);
      halo_numbers.push_back(
        std::lower_bound(first, by_owner.begin() + first_of_rank[owner + 1], global_numbers[l]) - first);
    }
    if (n_ranks > 1)
      exchange.reinit(n_own_nodes, halo_owners, halo_numbers);
  }



  void NodePartition::find_known(const std::vector<unsigned int> &owners, const std::vector<CellList> &lists)
  {
    std::vector<bool> known(owners.size(), false);
    for (const unsigned int node : global_numbers)
      known[node] = true;
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
        known[node] = true;
      global_numbers.insert(global_numbers.end(), added.begin(), added.end());
      if (layer == 0)
        n_row_nodes = global_numbers.size();
    }
  }



  std::vector<unsigned int> NodePartition::local_cells(const unsigned int list, const CellList &cells) const
  {
    std::vector<unsigned int> result;
    result.reserve(known_cells[list].size() * cells.nodes_per_cell);
    for (const unsigned int c : known_cells[list])
      for (const unsigned int *node = cells.begin(c); node != cells.end(c); ++node)
        result.push_back(local_numbers[*node]);
    return result;
  }



  std::vector<double> NodePartition::gather(const double *own, const unsigned int n_components,
                                            const Ranges &ranges) const
  {
    const unsigned int n_ranks = first_of_rank.size() - 1,
                       rank    = Utilities::MPI::this_mpi_process(mpi_communicator);
    // A rank's nodes in a range are neighbours in its order.
    const auto pieces_of = [&](const unsigned int r) {
      Ranges pieces; // places in by_owner
      for (const auto &[first, last] : ranges)
        pieces.emplace_back(std::lower_bound(by_owner.begin() + first_of_rank[r],
                                             by_owner.begin() + first_of_rank[r + 1], first) -
                              by_owner.begin(),
                            std::lower_bound(by_owner.begin() + first_of_rank[r],
                                             by_owner.begin() + first_of_rank[r + 1], last) -
                              by_owner.begin());
      return pieces;
    };
    std::vector<double> sent;
    for (const auto &[first, last] : pieces_of(rank))
      sent.insert(sent.end(), own + static_cast<std::size_t>(first - first_of_rank[rank]) * n_components,
                  own + static_cast<std::size_t>(last - first_of_rank[rank]) * n_components);
    if (n_ranks == 1)
      return sent;

    std::vector<int> counts(n_ranks, 0), offsets(n_ranks, 0);
    for (unsigned int r = 0; r < n_ranks; ++r)
    {
      for (const auto &[first, last] : pieces_of(r))
        counts[r] += n_components * (last - first);
      if (r > 0)
        offsets[r] = offsets[r - 1] + counts[r - 1];
    }
    std::vector<double> received(offsets.back() + counts.back()), result(received.size());
    const int ierr = MPI_Allgatherv(sent.data(), sent.size(), MPI_DOUBLE, received.data(), counts.data(),
                                    offsets.data(), MPI_DOUBLE, mpi_communicator);
    AssertThrowMPI(ierr);

    auto value = received.begin();
    for (unsigned int r = 0; r < n_ranks; ++r)
    {
      const Ranges pieces = pieces_of(r);
      for (unsigned int k = 0, n_before = 0; k < ranges.size();
           n_before += ranges[k].second - ranges[k].first, ++k)
        for (unsigned int i = pieces[k].first; i < pieces[k].second; ++i, value += n_components)
          std::copy_n(value, n_components,
                      result.begin() +
                        static_cast<std::size_t>(n_before + by_owner[i] - ranges[k].first) * n_components);
    }
    return result;
  }



  template <int dim>
  std::vector<unsigned int> share_nodes(const std::vector<Point<dim>> &positions,
                                        const std::vector<CellList> &lists, const unsigned int n_ranks)
  {
    const unsigned int n_nodes = positions.size();
    std::vector<unsigned int> weights(n_nodes, 1);
    for (const CellList &list : lists)
      for (const unsigned int *node = list.begin(0); node != list.begin(list.n_cells); ++node)
        ++weights[*node];

    // Along the curve, whose places have 10 bits a direction: ranks' borders need not be finer than a thousandth.
    constexpr int bits = 10;
    const auto curve   = Utilities::inverse_Hilbert_space_filling_curve(positions, bits);
    std::vector<std::pair<std::uint64_t, unsigned int>> order(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      order[i] = {Utilities::pack_integers<dim>(curve[i], bits), i};
    std::sort(order.begin(), order.end());

    const double all = std::accumulate(weights.begin(), weights.end(), 0.);
    std::vector<unsigned int> owners(n_nodes);
    double sum = 0.;
    for (const auto &[place, i] : order)
    {
      owners[i] = std::min<unsigned int>((sum + 0.5 * weights[i]) / all * n_ranks, n_ranks - 1);
      sum += weights[i];
    }
    return owners;
  }



  template std::vector<unsigned int> share_nodes<2>(const std::vector<Point<2>> &,
                                                    const std::vector<CellList> &, const unsigned int);
  template std::vector<unsigned int> share_nodes<3>(const std::vector<Point<3>> &,
                                                    const std::vector<CellList> &, const unsigned int);
} // namespace Lahar
