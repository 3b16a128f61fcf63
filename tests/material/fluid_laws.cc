// SPDX-License-Identifier: GPL-3.0-or-later

// Test the laws with a viscosity that depends on the strain rate: values and derivatives against formulas written apart
// and differentiated automatically, from 1e-9 to 1e6 1/s; stress that grows; finite viscosities at rest; limits; laws that
// contain each other; wrong parameters.

#include <Sacado.hpp>

#include <functional>

#include "material/laws.h"

using namespace Tests;

using Fad      = Sacado::Fad::SFad<long double, 1>;
using Function = std::function<Fad(const Fad &)>;

/// (1 − exp(−m γ̇))/γ̇: for small m γ̇ by its power series, which does not cancel.
Fad plastic(const long double m, const Fad &rate)
{
  const Fad z = m * rate;
  if (z.val() > 0.5L)
    return (1.L - exp(-z)) / rate;
  Fad sum = 1.L, power = 1.L;
  for (unsigned int k = 1; k < 25; ++k)
  {
    power = power * (-z) / (k + 1.L);
    sum   = sum + power;
  }
  return m * sum;
}

/// Value and derivative against the formula, stress that grows, the viscosity at rest, and yielding.
void test_formula(const std::string &name, const FluidLaw &law, const double at_rest, const Function &formula)
{
  double value_error = 0., derivative_error = 0., previous_stress = 0.;
  bool grows = true, yields = true;
  sweep([&](const double rate) {
    const auto viscosity = law.effective_viscosity(rate, 0.);
    const Fad reference  = formula(Fad(1, 0, rate));
    value_error          = std::max<double>(value_error, std::abs(viscosity.value / reference.val() - 1.L));
    // In terms of the stress's slope, in which a derivative of the viscosity near zero is nothing.
    derivative_error = std::max<double>(derivative_error, std::abs((viscosity.derivative - reference.dx(0)) *
                                                                   rate / reference.val()));
    const double stress = viscosity.value * rate;
    grows           = grows && stress > previous_stress && viscosity.value + rate * viscosity.derivative > 0.;
    previous_stress = stress;
    yields          = yields && law.is_yielded(rate, 0.) ==
                         (stress > law.yield_stress(0.).value || law.yield_stress(0.).value == 0.);
  });
  check(name + ": viscosity equals the formula", value_error, 1e-12);
  check(name + ": derivative equals automatic differentiation", derivative_error, 1e-8);
  check(name + ": stress grows with the strain rate", grows);
  check(name + ": yielded where the stress is above the yield stress", yields);
  double rest_error = 0.;
  bool finite       = true;
  for (const double rate : {0., 1e-300, 1e-150})
  {
    const auto viscosity = law.effective_viscosity(rate, 0.);
    rest_error           = std::max(rest_error, std::abs(viscosity.value / at_rest - 1.));
    // As it stands in the tangent: 2 μ'/γ̇ d', with d' of the size of γ̇.
    if (rate > 0.)
      finite = finite && std::isfinite(2. * viscosity.derivative / rate * rate);
  }
  check(name + ": viscosity at rest", rest_error, 1e-12);
  check(name + ": the tangent is finite there", finite);
}

void test_powers()
{
  const std::unique_ptr<FluidLaw> bingham = make_law("Bingham", {{"Plastic viscosity", to_text(K)},
                                                                 {"Yield stress", to_text(tau_0)}});
  for (const double n : {0.1, 0.4, 1., 1.5, 2.5})
  {
    const std::string name = " n = " + std::to_string(n).substr(0, 3);
    const auto power       = [n](const Fad &rate) -> Fad {
      return static_cast<long double>(K) *
             pow(rate * rate + static_cast<long double>(epsilon) * epsilon, (n - 1.L) / 2.L);
    };
    const double at_rest = K * std::pow(epsilon, n - 1.);
    const auto law       = herschel_bulkley(n, tau_0);
    test_formula("Herschel-Bulkley" + name, *law, at_rest + m * tau_0, [&](const Fad &rate) -> Fad {
      return power(rate) + static_cast<long double>(tau_0) * plastic(m, rate);
    });
    const auto without = make_law("power law", {{"Consistency", to_text(K)}, {"Flow index", to_text(n)}});
    test_formula("power law" + name, *without, at_rest, power);
    check("power law" + name + ": no yield stress",
          without->yield_stress(0.).value == 0. && without->is_yielded(0., 0.));
    test_same("Herschel-Bulkley" + name + " without yield stress is the power law", *herschel_bulkley(n, 0.),
              *without);

    // What ε changes of the stress, and what it does not.
    double error = 0., error_above = 0.;
    sweep([&](const double rate) {
      const double difference = std::abs(without->viscous_part(rate, 0.).value * rate -
                                         K * std::pow(rate, n));
      error                   = std::max(error, difference / (K * std::pow(epsilon, n)));
      if (rate > 100. * epsilon)
        error_above = std::max(error_above, difference / (K * std::pow(rate, n)));
    });
    if (n < 1.)
      check("power law" + name + ": stress to K epsilon^n", error, 1.);
    check("power law" + name + ": stress to 1e-4 for rates above 100 epsilon", error_above, 1e-4);
  }
  test_same("Herschel-Bulkley n = 1 is Bingham's law", *herschel_bulkley(1., tau_0), *bingham);
  test_same("power law n = 1 is Newton's law",
            *make_law("power law", {{"Consistency", "3.5"}, {"Flow index", "1"}}), *newtonian(3.5), 0.);
}

void test_casson()
{
  const double mu = 0.5;
  const auto make = [](const double mu, const double tau_0) {
    return make_law("Casson", {{"Casson viscosity", to_text(mu)}, {"Yield stress", to_text(tau_0)}});
  };
  const auto law = make(mu, tau_0);
  test_formula("Casson", *law, mu + 2. * std::sqrt(tau_0 * mu / epsilon) + m * tau_0,
               [&](const Fad &rate) -> Fad {
                 return mu +
                        2.L * std::sqrt(static_cast<long double>(tau_0 * mu)) *
                          pow(rate * rate + static_cast<long double>(epsilon) * epsilon, -0.25L) +
                        static_cast<long double>(tau_0) * plastic(m, rate);
               });
  double error = 0.;
  sweep([&](const double rate) {
    if (rate > 100. / m)
      error = std::max(error, std::abs(std::sqrt(law->effective_viscosity(rate, 0.).value * rate) -
                                       std::sqrt(tau_0) - std::sqrt(mu * rate)) /
                                std::sqrt(tau_0));
  });
  check("Casson: roots of the stresses add up", error, 1e-6);
  check("Casson: high rates", law->effective_viscosity(1e12, 0.).value / mu - 1., 1e-4);
  test_same("Casson without yield stress is Newton's law", *make(mu, 0.), *newtonian(mu), 0.);
  double plastic_error = 0.;
  sweep([&](const double rate) {
    plastic_error = std::max(plastic_error, std::abs(make(0., tau_0)->effective_viscosity(rate, 0.).value /
                                                       (tau_0 * law->plastic_part(rate).value) -
                                                     1.));
  });
  check("Casson without viscosity is the yield stress alone", plastic_error, 1e-14);
}

void test_plateaus()
{
  // Blood (Cho & Kensey, Biorheology 28 (1991) 241): 0.056 and 0.00345 Pa s, 3.313 s, n = 0.3568, a = 2.
  const double mu_0 = 0.056, mu_infinity = 0.00345, lambda = 3.313;
  for (const double n : {0.3568, 0.1, 1.2})
    for (const double a : {0.3, 1., 2., 10.})
    {
      const std::string name = "Carreau-Yasuda n = " + to_text(n).substr(0, 6) +
                               ", a = " + to_text(a).substr(0, 3);
      const auto law = carreau(mu_0, mu_infinity, lambda, n, a);
      test_formula(name, *law, mu_0, [&](const Fad &rate) -> Fad {
        return static_cast<long double>(mu_infinity) +
               (static_cast<long double>(mu_0) - mu_infinity) *
                 pow(1.L + pow(static_cast<long double>(lambda) * rate, static_cast<long double>(a)),
                     (n - 1.L) / static_cast<long double>(a));
      });
    }
  double error = 0.;
  sweep([&](const double rate) {
    const double exact = mu_infinity + (mu_0 - mu_infinity) *
                                         std::pow(1. + lambda * lambda * rate * rate, (0.3568 - 1.) / 2.);
    error = std::max(
      error,
      std::abs(carreau(mu_0, mu_infinity, lambda, 0.3568, 2.)->viscous_part(rate, 0.).value / exact - 1.));
  });
  check("Carreau-Yasuda a = 2 is Carreau's", error, 1e-13);
  check("Carreau-Yasuda: high rates",
        carreau(mu_0, mu_infinity, lambda, 0.3568, 2.)->viscous_part(1e12, 0.).value / mu_infinity - 1.,
        1e-6);
  check("Carreau-Yasuda: an infinite rate leaves numbers",
        std::isfinite(carreau(mu_0, mu_infinity, lambda, 0.5, 10.)->viscous_part(1e200, 0.).derivative));
  test_same("Carreau-Yasuda without time constant is Newton's law", *carreau(2., 1., 0., 0.5, 2.),
            *newtonian(2.), 0.);
  test_same("Carreau-Yasuda n = 1 is Newton's law", *carreau(2., 1., 3., 1., 2.), *newtonian(2.));
  test_same("Carreau-Yasuda with equal viscosities is Newton's law", *carreau(2., 2., 3., 0.5, 2.),
            *newtonian(2.));
  test_same("a = 1 - n: Carreau-Yasuda is Cross's law", *carreau(2., 0.1, 3., 0.3, 0.7),
            *cross(2., 0.1, 3., 0.7), 1e-12);

  struct Plateaus
  {
    double mu_0, mu_infinity, q;
  };
  // The last but one is the least viscosity at high rates for its exponent; the last one thickens.
  for (const Plateaus &p :
       {Plateaus{0.056, 0., 0.1}, {0.056, 0.00345, 1.}, {9., 3. + 1e-9, 2. + std::sqrt(3.)}, {0.1, 2., 3.}})
  {
    const auto law = cross(p.mu_0, p.mu_infinity, lambda, p.q);
    test_formula("Cross q = " + to_text(p.q).substr(0, 3), *law, p.mu_0, [&](const Fad &rate) -> Fad {
      return static_cast<long double>(p.mu_infinity) +
             (static_cast<long double>(p.mu_0) - p.mu_infinity) /
               (1.L + pow(static_cast<long double>(lambda) * rate, static_cast<long double>(p.q)));
    });
  }
  check("Cross: halfway at the rate 1/k", cross(2., 1., 4., 0.8)->viscous_part(0.25, 0.).value - 1.5, 1e-14);
  check("Cross: high rates", cross(2., 0.5, 4., 1.)->viscous_part(1e12, 0.).value / 0.5 - 1., 1e-11);
  test_same("Cross without time constant is Newton's law", *cross(2., 1., 0., 0.5), *newtonian(2.), 0.);
}

void test_refused()
{
  check_refused({{"Herschel-Bulkley", "Consistency", "-1"},
                 {"Herschel-Bulkley", "Flow index", "0"},
                 {"Herschel-Bulkley", "Flow index", "-0.5"},
                 {"Herschel-Bulkley", "Yield stress", "-1"},
                 {"Herschel-Bulkley", "Smallest strain rate", "0"},
                 {"Herschel-Bulkley", "Regularization parameter", "0"},
                 {"Herschel-Bulkley", "Density", "0"},
                 {"power law", "Consistency", "-2"},
                 {"power law", "Flow index", "0"},
                 {"power law", "Smallest strain rate", "-1"},
                 {"Casson", "Casson viscosity", "-1"},
                 {"Casson", "Yield stress", "-3"},
                 {"Casson", "Smallest strain rate", "0"},
                 {"Casson", "Regularization parameter", "-1"},
                 {"Carreau-Yasuda", "Viscosity at rest", "-1"},
                 {"Carreau-Yasuda", "Viscosity at high rates", "-1"},
                 {"Carreau-Yasuda", "Time constant", "-1"},
                 {"Carreau-Yasuda", "Flow index", "0"},
                 {"Carreau-Yasuda", "Exponent of the bend", "0"},
                 {"Carreau-Yasuda", "Exponent of the bend", "11"},
                 {"Cross", "Viscosity at rest", "-1"},
                 {"Cross", "Viscosity at high rates", "-1"},
                 {"Cross", "Time constant", "-1"},
                 {"Cross", "Exponent", "0"},
                 {"Cross", "Exponent", "1.5"}});
  check_throws<InputError>("Carreau-Yasuda: n > 1 with a viscosity that would become negative",
                           {"'Carreau-Yasuda/Flow index'", "'1.5'", "Allowed", "negative"},
                           [] { carreau(1., 2., 1., 1.5, 2.); });
  check_throws<InputError>("Cross: a viscosity at high rates for which the stress would fall",
                           {"'Cross/Exponent'", "Allowed", "grows"},
                           [] { cross(9., 3. - 1e-9, 1., 2. + std::sqrt(3.)); });
}

int main()
{
  test_powers();
  test_casson();
  test_plateaus();
  test_refused();
  return n_failed;
}
