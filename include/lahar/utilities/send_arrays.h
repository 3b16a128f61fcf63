// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_send_arrays_h
#define lahar_utilities_send_arrays_h

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <type_traits>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Send other ranks an array each, by rank, and receive theirs. No copy is made of an array, and messages go only
   * between ranks that have something to tell each other. Collective.
   */
  template <typename T>
  std::map<unsigned int, std::vector<T>> send_arrays(const std::map<unsigned int, std::vector<T>> &sent,
                                                     const MPI_Comm &communicator)
  {
    static_assert(std::is_trivially_copyable<T>::value, "Arrays are sent as bytes.");
    constexpr int tag           = 8;
    constexpr std::size_t piece = std::size_t(1) << 30; // bytes of a message, which count as an int

    std::map<unsigned int, std::vector<std::uint64_t>> sizes;
    for (const auto &[rank, array] : sent)
      if (!array.empty())
        sizes[rank] = {array.size()};
    std::map<unsigned int, std::vector<T>> received;
    std::vector<MPI_Request> requests;
    const auto for_pieces = [&](const std::size_t n_bytes, const auto &start) {
      for (std::size_t begin = 0; begin < n_bytes; begin += piece)
      {
        requests.emplace_back();
        const int ierr = start(begin, static_cast<int>(std::min(piece, n_bytes - begin)), &requests.back());
        AssertThrowMPI(ierr);
      }
    };
    for (const auto &[rank, size] : Utilities::MPI::some_to_some(communicator, sizes))
    {
      std::vector<T> &array = received[rank];
      array.resize(size[0]);
      char *bytes  = reinterpret_cast<char *>(array.data());
      const int of = rank;
      for_pieces(array.size() * sizeof(T), [&](const std::size_t begin, const int n, MPI_Request *request) {
        return MPI_Irecv(bytes + begin, n, MPI_BYTE, of, tag, communicator, request);
      });
    }
    for (const auto &[rank, array] : sent)
    {
      const char *bytes = reinterpret_cast<const char *>(array.data());
      const int to      = rank;
      for_pieces(array.size() * sizeof(T), [&](const std::size_t begin, const int n, MPI_Request *request) {
        return MPI_Isend(bytes + begin, n, MPI_BYTE, to, tag, communicator, request);
      });
    }
    const int ierr = MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    AssertThrowMPI(ierr);
    return received;
  }
} // namespace Lahar

#endif
