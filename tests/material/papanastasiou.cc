// SPDX-License-Identifier: GPL-3.0-or-later

// Test the Bingham-Papanastasiou and the Newtonian law: viscosity and its derivative against automatic differentiation
// over eighteen decades of the strain rate, both limits, monotone stress, yielding, and wrong parameters.

#include <Sacado.hpp>

#include "tests.h"

#include <iomanip>
#include <sstream>

using namespace Tests;

using Fad = Sacado::Fad::SFad<long double, 1>;

std::string to_text(const double value)
{
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

/// f = (1 − exp(−z))/z m: for small z by its power series, which does not cancel.
Fad plastic_part(const long double m, const Fad &rate)
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

std::unique_ptr<FluidLaw> bingham(const double mu, const double tau_0, const double m)
{
  return make_law("Bingham", {{"Plastic viscosity", to_text(mu)},
                              {"Yield stress", to_text(tau_0)},
                              {"Regularization parameter", to_text(m)}});
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double mu = 0.5, tau_0 = 120.;
  double value_error = 0., derivative_error = 0., limit_error = 0., plateau_error = 0.;
  bool monotone = true, yields_once = true, falls = true;
  for (double m = 0.1; m < 2e6; m *= 10.)
  {
    const auto law         = bingham(mu, tau_0, m);
    double previous_stress = 0.;
    bool was_yielded       = false;
    for (double rate = 1e-12; rate < 1.5e6; rate *= 1.25)
    {
      const FluidLaw::Value viscosity = law->effective_viscosity(rate, 0.);
      const Fad reference             = static_cast<long double>(mu) +
                            static_cast<long double>(tau_0) * plastic_part(m, Fad(1, 0, rate));
      value_error      = std::max<double>(value_error, std::abs(viscosity.value / reference.val() - 1.L));
      derivative_error = std::max<double>(derivative_error,
                                          std::abs(viscosity.derivative / reference.dx(0) - 1.L));
      falls            = falls && viscosity.derivative < 0.;

      const double stress = viscosity.value * rate;
      monotone            = monotone && stress > previous_stress;
      previous_stress     = stress;

      // |τ| = τ0 at μ γ̇ = τ0 exp(−m γ̇): yielding begins there and does not end again.
      const bool expected = mu * rate > tau_0 * std::exp(-m * rate);
      yields_once         = yields_once && law->is_yielded(rate, 0.) == expected && expected >= was_yielded;
      was_yielded         = expected;
      if (m * rate > 50.)
        plateau_error = std::max(plateau_error, stress / (tau_0 + mu * rate) - 1.);
    }
    for (const double rate : {0., 1e-300})
    {
      limit_error = std::max(limit_error,
                             std::abs(law->effective_viscosity(rate, 0.).value / (mu + m * tau_0) - 1.));
      limit_error =
        std::max(limit_error,
                 std::abs(law->effective_viscosity(rate, 0.).derivative / (-0.5 * m * m * tau_0) - 1.));
    }
  }
  check("viscosity equals the reference", value_error, 1e-12);
  check("derivative equals automatic differentiation", derivative_error, 1e-8);
  check("viscosity falls with the strain rate", falls);
  check("limit of no strain rate: mu + m tau_0, derivative -m^2 tau_0/2", limit_error, 1e-14);
  check("limit m -> infinity: |tau| -> tau_0 + mu rate", plateau_error, 1e-14);
  check("stress grows with the strain rate", monotone);
  check("yielded where |tau| > tau_0", yields_once);
  check("without yield stress everything is yielded", bingham(1., 0., 10.)->is_yielded(0., 0.));

  const auto newtonian = make_law("Newtonian", {{"Viscosity", "3.5"}, {"Density", "900"}});
  check("Newtonian viscosity", newtonian->effective_viscosity(17., 0.).value - 3.5, 0.);
  check("Newtonian derivative", newtonian->effective_viscosity(17., 0.).derivative, 0.);
  check("Newtonian fluid is yielded",
        newtonian->is_yielded(0., 0.) && newtonian->yield_stress(0.).value == 0.);
  check("density", newtonian->density() - 900., 0.);
  check("incompressible by default", newtonian->compressibility(), 0.);
  check("bulk modulus", make_law("Newtonian", {{"Bulk modulus", "4e9"}})->compressibility() * 4e9 - 1.,
        1e-15);

  for (const auto &[entry, value] : Entries{{"Density", "0"},
                                            {"Density", "-1"},
                                            {"Bulk modulus", "0"},
                                            {"Bulk modulus", "soft"},
                                            {"Plastic viscosity", "-1e-3"},
                                            {"Yield stress", "-1"},
                                            {"Regularization parameter", "0"}})
    check_throws<InputError>(entry + " = " + value + " is refused",
                             {"'Bingham/" + entry + "'", "'" + value + "'", "Allowed"},
                             [&, e = entry, v = value]() {
                               make_law("Bingham", {{e, v}});
                             });
  return n_failed;
}
