// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/exceptions.h>

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/process_start.h>
#include <lahar/utilities/ranks.h>

#include <memory>
#include <new>
#include <regex>
#include <sstream>

namespace Lahar
{
  namespace
  {
    std::unique_ptr<char[]> reserve;

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
      const Failure failure = Failure::current();
      fail_on_all_ranks(communicator,
                        (failure.status == 2 ? "lahar: wrong input. " : "lahar: the run failed. ") +
                          failure.message,
                        failure.status);
      return failure.status;
    }
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
