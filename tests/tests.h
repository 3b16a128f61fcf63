// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_h
#define lahar_tests_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <lahar/material/fluid_law.h>

#include <cmath>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

namespace Tests
{
  using namespace Lahar;

  /// Number of failed checks; main() returns it, so that no output file can bless a wrong result.
  inline int n_failed = 0;

  /// With several ranks, check that the condition holds on all of them.
  inline void check(const std::string &what, const bool condition)
  {
    const bool parallel   = Utilities::MPI::job_supports_mpi(); // false where MPI was not initialised
    const bool everywhere = parallel ? Utilities::MPI::min(condition ? 1U : 0U, MPI_COMM_WORLD) == 1U
                                     : condition;
    if (!parallel || Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << (everywhere ? "ok: " : "FAILED: ") << what << std::endl;
    n_failed += !everywhere;
  }

  /// Check that |error| is at most the tolerance.
  inline void check(const std::string &what, const double error, const double tolerance)
  {
    check(what, std::abs(error) <= tolerance);
    if (!(std::abs(error) <= tolerance))
      std::cout << "    error " << error << ", tolerance " << tolerance << std::endl;
  }

  /// Check that @p function throws an @p Error whose message holds all of @p parts.
  template <typename Error, typename F>
  void check_throws(const std::string &what, const std::vector<std::string> &parts, const F &function)
  {
    std::string message = "(nothing thrown)";
    bool thrown         = false;
    try
    {
      function();
    }
    catch (const Error &error)
    {
      thrown  = true;
      message = error.what();
      for (const std::string &part : parts)
        thrown = thrown && message.find(part) != std::string::npos;
    }
    check(what, thrown);
    if (!thrown)
      std::cout << "    " << message << std::endl;
  }

  /// Random numbers that are the same on every machine.
  class Random
  {
  public:
    /// In [−1, 1].
    double number()
    {
      return 2. * (engine() / 4294967295.) - 1.;
    }

    template <int dim>
    Tensor<1, dim> vector()
    {
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = number();
      return result;
    }

  private:
    std::mt19937 engine;
  };

  using Entries = std::vector<std::pair<std::string, std::string>>;

  /// The law @p name with the given entries.
  inline std::unique_ptr<FluidLaw> make_law(const std::string &name, const Entries &entries)
  {
    Parameters prm;
    FluidLaw::declare_parameters(prm);
    prm.set("Law", name);
    prm.enter_subsection(name);
    for (const auto &[entry, value] : entries)
      prm.set(entry, value);
    prm.leave_subsection();
    return FluidLaw::create(prm);
  }

  /// @p object with its default parameters but for those that @p text, in the format of a .prm file, sets.
  template <typename T>
  void parse(T &object, const std::string &text = "")
  {
    Parameters prm;
    T::declare_parameters(prm);
    prm.parse_input_from_string(text);
    object.parse_parameters(prm);
  }
} // namespace Tests

#endif
