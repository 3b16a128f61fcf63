// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/vector.hpp>

#include <lahar/utilities/halo_exchange.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  HaloExchange::HaloExchange(const MPI_Comm &communicator)
    : communicator(communicator)
  {}



  void HaloExchange::reinit(const std::vector<unsigned int> &copies, const std::vector<unsigned int> &owners,
                            const std::vector<std::uint64_t> &keys,
                            const std::function<unsigned int(const std::uint64_t)> &find)
  {
    AssertDimension(owners.size(), copies.size());
    AssertDimension(keys.size(), copies.size());
    std::map<unsigned int, Neighbour> by_rank;
    std::map<unsigned int, std::vector<std::uint64_t>> wanted;
    for (unsigned int i = 0; i < copies.size(); ++i)
    {
      wanted[owners[i]].push_back(keys[i]);
      by_rank[owners[i]].received.push_back(copies[i]);
    }
    for (const auto &[rank, their_keys] : Utilities::MPI::some_to_some(communicator, wanted))
      for (const std::uint64_t key : their_keys)
        by_rank[rank].sent.push_back(find(key));

    neighbours.clear();
    for (auto &[rank, neighbour] : by_rank)
    {
      neighbour.rank = rank;
      neighbours.push_back(std::move(neighbour));
    }
  }



  void HaloExchange::update(double *values, const unsigned int n_components) const
  {
    constexpr int tag = 7;
    std::vector<std::vector<double>> sent(neighbours.size()), received(neighbours.size());
    std::vector<MPI_Request> requests;
    for (unsigned int k = 0; k < neighbours.size(); ++k)
    {
      received[k].resize(neighbours[k].received.size() * n_components);
      if (!received[k].empty())
      {
        requests.emplace_back();
        const int ierr = MPI_Irecv(received[k].data(), received[k].size(), MPI_DOUBLE, neighbours[k].rank,
                                   tag, communicator, &requests.back());
        AssertThrowMPI(ierr);
      }
    }
    for (unsigned int k = 0; k < neighbours.size(); ++k)
    {
      for (const unsigned int i : neighbours[k].sent)
      {
        const double *first = values + static_cast<std::size_t>(i) * n_components;
        sent[k].insert(sent[k].end(), first, first + n_components);
      }
      if (!sent[k].empty())
      {
        requests.emplace_back();
        const int ierr = MPI_Isend(sent[k].data(), sent[k].size(), MPI_DOUBLE, neighbours[k].rank, tag,
                                   communicator, &requests.back());
        AssertThrowMPI(ierr);
      }
    }
    const int ierr = MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    AssertThrowMPI(ierr);
    for (unsigned int k = 0; k < neighbours.size(); ++k)
      for (unsigned int i = 0; i < neighbours[k].received.size(); ++i)
        std::copy_n(received[k].begin() + static_cast<std::size_t>(i) * n_components, n_components,
                    values + static_cast<std::size_t>(neighbours[k].received[i]) * n_components);
  }
} // namespace Lahar
