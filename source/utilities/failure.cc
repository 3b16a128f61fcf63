// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/exceptions.h>

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/process_start.h>
#include <lahar/utilities/ranks.h>

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <iostream>
#include <memory>
#include <new>
#include <regex>
#include <sstream>

namespace Lahar
{
  namespace
  {
    std::unique_ptr<char[]> reserve;

    /// Of fixed size, for handlers of signals.
    std::array<char, PATH_MAX> failure_log{};

    /// Message and place of an exception of deal.II's, whose what() has the frames, too.
    std::string describe(const ExceptionBase &error)
    {
      std::ostringstream info;
      error.print_info(info);
      const std::string whole = error.what();
      std::smatch place;
      const bool has_place = std::regex_search(whole, place, std::regex("line <(\\d+)> of file <([^>]*)>"));
      return "deal.II: " + std::regex_replace(info.str(), std::regex("\\s+"), " ") + "(" +
             error.get_exc_name() + (has_place ? ", " + place[2].str() + ":" + place[1].str() : "") + ")";
    }
  } // namespace



  Failure Failure::current()
  {
    try
    {
      throw;
    }
    catch (const InputError &error)
    {
      return {2, error.what()};
    }
    catch (const std::bad_alloc &)
    {
      return {1, "There is not enough memory" + address_space_limit() +
                   ": 'Mesh size' and the elements of solids are what it depends on."};
    }
    catch (const ExceptionBase &error)
    {
      return {1, describe(error)};
    }
    catch (const std::exception &error) // RunError, too
    {
      return {1, error.what()};
    }
    catch (...)
    {
      return {1, "A library has failed without saying why."};
    }
  }



  int exit_status(const MPI_Comm &communicator, const std::function<void()> &action)
  {
    try
    {
      action();
      return 0;
    }
    catch (...)
    {
      const Failure failure  = Failure::current();
      const bool is_alone    = !all_ranks_arrive(communicator);
      const bool is_recorder = is_first_rank(communicator); // its run has written the reason into the log
      if (is_alone || is_recorder)
        std::cerr << (failure.status == 2 ? "lahar: wrong input. " : "lahar: the run failed. ")
                  << failure.message << std::endl;
      if (is_alone && !is_recorder)
        log_failure(failure.message.c_str());
      if (is_alone)
        MPI_Abort(communicator, failure.status);
      return failure.status;
    }
  }



  void set_failure_log(const std::string &file_name)
  {
    failure_log.fill(0);
    if (file_name.size() < failure_log.size())
      std::copy(file_name.begin(), file_name.end(), failure_log.begin());
  }



  void log_failure(const char *reason) noexcept
  {
    const int file = failure_log[0] == 0 ? -1 : ::open(failure_log.data(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (file < 0)
      return;
    constexpr char begin[] = "The run failed. ", end[] = "\n";
    const ::iovec parts[] = {{const_cast<char *>(begin), sizeof(begin) - 1},
                             {const_cast<char *>(reason), std::strlen(reason)},
                             {const_cast<char *>(end), sizeof(end) - 1}};
    if (::writev(file, parts, 3) < 0)
      errno = 0; // it stands on the screen
    ::close(file);
  }



  void reserve_memory_for_failure()
  {
    reserve.reset(new char[4 * 1024 * 1024]);
    std::set_new_handler([] {
      reserve.reset();
      std::set_new_handler(nullptr);
      throw std::bad_alloc();
    });
  }
} // namespace Lahar
