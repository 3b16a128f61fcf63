// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_material_laws_h
#define lahar_tests_material_laws_h

#include "tests.h"

#include <functional>
#include <iomanip>
#include <sstream>
#include <vector>

namespace Tests
{
  constexpr double lowest_rate = 1e-9, highest_rate = 1e6;

  inline std::string to_text(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
  }

  /// Call @p f at strain rates over all decades.
  inline void sweep(const std::function<void(double)> &f)
  {
    for (double rate = lowest_rate; rate < highest_rate; rate *= 1.3)
      f(rate);
  }

  /// The same law twice.
  inline void test_same(const std::string &what, const FluidLaw &a, const FluidLaw &b,
                        const double tolerance = 1e-14)
  {
    double error = std::abs(a.yield_stress(0.).value - b.yield_stress(0.).value) /
                   std::max(1., b.yield_stress(0.).value);
    sweep([&](const double rate) {
      const auto mu_a = a.effective_viscosity(rate, 0.), mu_b = b.effective_viscosity(rate, 0.);
      error = std::max({error, std::abs(mu_a.value / mu_b.value - 1.),
                        std::abs(mu_a.derivative - mu_b.derivative) * rate / mu_b.value});
    });
    check(what, error, tolerance);
  }

  inline std::unique_ptr<FluidLaw> newtonian(const double mu)
  {
    return make_law("Newtonian", {{"Viscosity", to_text(mu)}});
  }

  const double K = 30., tau_0 = 80., m = 1000., epsilon = 1e-4;

  inline std::unique_ptr<FluidLaw> herschel_bulkley(const double n, const double yield_stress)
  {
    return make_law("Herschel-Bulkley", {{"Consistency", to_text(K)},
                                         {"Flow index", to_text(n)},
                                         {"Yield stress", to_text(yield_stress)}});
  }

  inline std::unique_ptr<FluidLaw> carreau(const double mu_0, const double mu_infinity, const double lambda,
                                           const double n, const double a)
  {
    return make_law("Carreau-Yasuda", {{"Viscosity at rest", to_text(mu_0)},
                                       {"Viscosity at high rates", to_text(mu_infinity)},
                                       {"Time constant", to_text(lambda)},
                                       {"Flow index", to_text(n)},
                                       {"Exponent of the bend", to_text(a)}});
  }

  inline std::unique_ptr<FluidLaw> cross(const double mu_0, const double mu_infinity, const double k,
                                         const double q)
  {
    return make_law("Cross", {{"Viscosity at rest", to_text(mu_0)},
                              {"Viscosity at high rates", to_text(mu_infinity)},
                              {"Time constant", to_text(k)},
                              {"Exponent", to_text(q)}});
  }

  /// A value that a law must refuse.
  struct WrongEntry
  {
    std::string law, entry, value;
  };

  /// Each value is refused with the entry's path, the value and what is allowed.
  inline void check_refused(const std::vector<WrongEntry> &all)
  {
    for (const WrongEntry &wrong : all)
      check_throws<InputError>(wrong.law + ": " + wrong.entry + " = " + wrong.value + " is refused",
                               {"'" + wrong.law + "/" + wrong.entry + "'", "'" + wrong.value + "'",
                                "Allowed"},
                               [&wrong]() {
                                 make_law(wrong.law, {{wrong.entry, wrong.value}});
                               });
  }
} // namespace Tests

#endif
