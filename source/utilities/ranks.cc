// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/ranks.h>

#include <boost/serialization/utility.hpp>

#include <chrono>
#include <thread>

namespace Lahar
{
  namespace
  {
    /// How long the other ranks have to arrive.
    constexpr std::chrono::seconds rank_patience(5);
  } // namespace



  bool is_first_rank(const MPI_Comm &communicator)
  {
    return Utilities::MPI::this_mpi_process(communicator) == 0;
  }



  void on_first_rank(const MPI_Comm &communicator, const std::function<void()> &action)
  {
    on_all_ranks(communicator, [&] {
      if (is_first_rank(communicator))
        action();
    });
  }



  void on_all_ranks(const MPI_Comm &communicator, const std::function<void()> &action)
  {
    Failure failure{0, ""};
    try
    {
      action();
    }
    catch (...)
    {
      failure = Failure::current();
    }
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator),
                       rank    = Utilities::MPI::this_mpi_process(communicator),
                       failed  = Utilities::MPI::min(failure.status == 0 ? n_ranks : rank, communicator);
    if (failed == n_ranks)
      return;
    const auto news = Utilities::MPI::broadcast(communicator, std::make_pair(failure.status, failure.message),
                                                failed);
    if (news.first == 2)
      throw InputError(news.second);
    throw RunError(news.second);
  }



  template <int dim>
  std::pair<double, Point<dim>> largest_of_all(const double value, const Point<dim> &place,
                                               const MPI_Comm &communicator)
  {
    struct
    {
      double value;
      int rank;
    } own          = {value, static_cast<int>(Utilities::MPI::this_mpi_process(communicator))}, largest;
    const int ierr = MPI_Allreduce(&own, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator);
    AssertThrowMPI(ierr);
    return {largest.value, Utilities::MPI::broadcast(communicator, place, largest.rank)};
  }

  template std::pair<double, Point<2>> largest_of_all(const double, const Point<2> &, const MPI_Comm &);
  template std::pair<double, Point<3>> largest_of_all(const double, const Point<3> &, const MPI_Comm &);



  bool all_ranks_arrive(const MPI_Comm &communicator)
  {
    MPI_Request request;
    MPI_Ibarrier(communicator, &request);
    const auto start = std::chrono::steady_clock::now();
    int all_are_here = 0;
    while (all_are_here == 0 && std::chrono::steady_clock::now() - start < rank_patience)
    {
      MPI_Test(&request, &all_are_here, MPI_STATUS_IGNORE);
      if (all_are_here == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return all_are_here != 0;
  }
} // namespace Lahar
