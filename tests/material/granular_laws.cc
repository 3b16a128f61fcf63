// SPDX-License-Identifier: GPL-3.0-or-later

// Test the laws that depend on the pressure: values and both derivatives against formulas written apart and differentiated
// automatically, for strain rates from 0 to 1e6 1/s and pressures from 0 to 1e6 Pa; stress that grows with both; laws that
// contain each other; where they are well-posed; wrong parameters.

#include <Sacado.hpp>

#include <functional>

#include "material/laws.h"

using namespace Tests;

using Fad      = Sacado::Fad::SFad<long double, 2>;
using Function = std::function<Fad(const Fad &rate, const Fad &pressure)>;

constexpr long double rho_s = 2500.L, d_g = 2e-3L, viscosity = 0.05L, cohesion = 3.L;

/// (1 − exp(−m γ̇))/γ̇: for small m γ̇ by its power series, which does not cancel.
Fad plastic(const Fad &rate)
{
  const Fad z = static_cast<long double>(m) * rate;
  if (z.val() > 0.5L)
    return (1.L - exp(-z)) / rate;
  Fad sum = 1.L, power = 1.L;
  for (unsigned int k = 1; k < 25; ++k)
  {
    power = power * (-z) / (k + 1.L);
    sum   = sum + power;
  }
  return static_cast<long double>(m) * sum;
}

/// What the grains are: glass (Barker & Gray 2017), grains of Lagrée, Staron & Popinet (2011).
struct Grains
{
  std::string name;
  double mu_s, mu_d, I_0, lower, upper; ///< the latter two the range of I in which μ(I) is well-posed

  Entries entries() const
  {
    return {{"Density", "1500"},
            {"Grain density", to_text(double(rho_s))},
            {"Grain diameter", to_text(double(d_g))},
            {"Static friction", to_text(mu_s)},
            {"Dynamic friction", to_text(mu_d)},
            {"Reference inertial number", to_text(I_0)},
            {"Viscosity", to_text(double(viscosity))}};
  }

  std::unique_ptr<FluidLaw> law(const std::string &name, const Entries &more = {}) const
  {
    Entries all = entries();
    all.insert(all.end(), more.begin(), more.end());
    return make_law(name, all);
  }

  template <typename Number>
  Number mu(const Number &I, const long double slope = 0.L) const
  {
    return (mu_s * static_cast<long double>(I_0) + mu_d * I + slope * I * I) /
           (I + static_cast<long double>(I_0));
  }
};

const std::vector<Grains> all_grains = {{"glass", std::tan(20.9 * numbers::PI / 180.),
                                         std::tan(32.76 * numbers::PI / 180.), 0.279, 0.0194, 0.852},
                                        {"contact dynamics", 0.32, 0.60, 0.4, 0.0136, 1.81}};

Fad inertial_number(const Fad &rate, const Fad &pressure)
{
  return rate * d_g / sqrt(pressure / rho_s);
}

void test_formula(const std::string &name, const FluidLaw &law, const Function &formula)
{
  double value_error = 0., rate_error = 0., pressure_error = 0.;
  bool grows = true, yields = true;
  for (const double pressure : {1e-6, 1e-2, 1., 30., 1e3, 1e6})
  {
    double previous = 0.;
    sweep([&](const double rate) {
      const auto found    = law.effective_viscosity(rate, pressure);
      const Fad reference = formula(Fad(2, 0, rate), Fad(2, 1, pressure));
      const auto relative = [&](const double derivative, const long double exact, const double argument) {
        return static_cast<double>(std::abs((derivative - exact) * argument / reference.val()));
      };
      value_error = std::max(value_error, static_cast<double>(std::abs(found.value / reference.val() - 1.L)));
      rate_error  = std::max(rate_error, relative(found.derivative, reference.dx(0), rate));
      pressure_error      = std::max(pressure_error,
                                     relative(found.pressure_derivative, reference.dx(1), pressure));
      const double stress = found.value * rate;
      grows               = grows && stress > previous && found.pressure_derivative >= 0.;
      previous            = stress;
      const double tau_y  = law.yield_stress(pressure).value;
      yields              = yields && law.is_yielded(rate, pressure) == (stress > tau_y || tau_y == 0.);
    });
  }
  check(name + ": viscosity equals the formula", value_error, 1e-12);
  check(name + ": derivative by the strain rate equals automatic differentiation", rate_error, 1e-8);
  check(name + ": derivative by the pressure equals automatic differentiation", pressure_error, 1e-12);
  check(name + ": stress grows with the strain rate, and does not fall with the pressure", grows);
  check(name + ": yielded where the stress is above the yield stress", yields);

  // At rest, without pressure, and next to both.
  bool finite = true;
  for (const double rate : {0., 1e-300, 1e-12, 1., 1e6})
    for (const double pressure : {0., 1e-300, 1e-12, 1., 1e6})
    {
      const auto found = law.effective_viscosity(rate, pressure);
      finite = finite && found.value >= 0. && std::isfinite(found.value) && std::isfinite(found.derivative) &&
               std::isfinite(rate * found.pressure_derivative);
    }
  check(name + ": finite at rest and without pressure", finite);
  check(name + ": has a yield stress if and only if some pressure gives one",
        law.has_yield_stress() == (law.yield_stress(1e-3).value > 0.));
}

void test_drucker_prager()
{
  for (const double angle : {0., 30., 89.9})
  {
    const long double c    = static_cast<long double>(std::cos(angle * numbers::PI / 180.)),
                      s    = static_cast<long double>(std::sin(angle * numbers::PI / 180.));
    const Entries entries  = {{"Cohesion", to_text(double(cohesion))},
                              {"Friction angle", to_text(angle)},
                              {"Viscosity", to_text(double(viscosity))}};
    const std::string name = "Drucker-Prager " + to_text(angle).substr(0, 4);
    const auto law         = make_law("Drucker-Prager", entries);
    test_formula(name, *law, [&](const Fad &rate, const Fad &pressure) -> Fad {
      return viscosity + (cohesion * c + s * pressure) * plastic(rate);
    });
    // Mohr's circle in the plane touches |τ| = c + σ tan φ: its radius is (c cot φ + P) sin φ.
    if (angle > 0.)
      check(name + ": the criterion of Mohr and Coulomb",
            law->yield_stress(7.).value / ((double(cohesion) * c / s + 7.) * s) - 1., 1e-14);
  }
  test_same("Drucker-Prager without friction is Bingham's law",
            *make_law("Drucker-Prager", {{"Cohesion", "80"}, {"Friction angle", "0"}, {"Viscosity", "30"}}),
            *make_law("Bingham", {{"Plastic viscosity", "30"}, {"Yield stress", "80"}}), 0.);
}

void test_mu_of_i(const Grains &grains)
{
  const std::string name = "mu(I), " + grains.name;
  const auto law         = grains.law("mu(I)", {{"Cohesion", to_text(double(cohesion))}});
  test_formula(name, *law, [&](const Fad &rate, const Fad &pressure) -> Fad {
    const Fad part = (static_cast<long double>(grains.mu_d) - grains.mu_s) * pressure /
                     (rate + grains.I_0 / d_g * sqrt(pressure / rho_s));
    return viscosity + part + (cohesion + grains.mu_s * pressure) * plastic(rate);
  });
  // The parts add up to μ(I) P where the yield stress is not regularised any more.
  double error = 0.;
  for (const double pressure : {1e-2, 1., 1e3})
    sweep([&](const double rate) {
      if (rate < 40. / m)
        return;
      const double I     = rate * double(d_g) / std::sqrt(pressure / double(rho_s));
      const double exact = double(viscosity) * rate + double(cohesion) +
                           grains.mu(static_cast<long double>(I)) * pressure;
      error = std::max(error, std::abs(law->effective_viscosity(rate, pressure).value * rate / exact - 1.));
    });
  check(name + ": the parts add up to mu(I) P", error, 1e-13);
  check(name + ": viscosity at rest without pressure",
        law->effective_viscosity(0., 0.).value / double(viscosity + m * cohesion) - 1., 1e-14);

  // The range in which it is well-posed, without the yield stress' regularisation.
  const auto rate_at = [&](const double I) { return I * std::sqrt(1e6 / double(rho_s)) / double(d_g); };
  check(name + ": well-posed in the middle, not beside",
        law->may_be_ill_posed() && law->is_well_posed(rate_at(1.01 * grains.lower), 1e6) &&
          !law->is_well_posed(rate_at(0.99 * grains.lower), 1e6) &&
          law->is_well_posed(rate_at(0.99 * grains.upper), 1e6) &&
          !law->is_well_posed(rate_at(1.01 * grains.upper), 1e6));
  check(name + ": at rest and without pressure there is nothing to say",
        law->is_well_posed(0., 1e6) && law->is_well_posed(1., 0.));
}

void test_barker_gray(const Grains &grains)
{
  const std::string name  = "Barker-Gray, " + grains.name;
  const long double slope = 0.05L, alpha = 1.9L, epsilon = 1e-4L;
  const auto law = grains.law("mu(I) Barker-Gray", {{"Friction slope", "0.05"},
                                                    {"Creep exponent", "1.9"},
                                                    {"Smallest strain rate", "1e-4"}});

  // The least I from which on the upper branch is well-posed: C in the derivative's own terms, by bisection.
  const auto C = [&](const long double I) {
    const Fad x(2, 0, I), mu = grains.mu(x);
    const long double nu = mu.dx(0) * I / mu.val();
    return 4.L * nu * nu - 4.L * nu + mu.val() * mu.val() * (1.L - nu / 2.L) * (1.L - nu / 2.L);
  };
  long double below = 1e-4L, above = 0.1L;
  for (unsigned int i = 0; i < 100; ++i)
    (C((below + above) / 2.L) > 0.L ? below : above) = (below + above) / 2.L;
  const long double I_1 = above, mu_1 = grains.mu(I_1, slope), log_A = std::log(I_1) + alpha / (mu_1 * mu_1);
  test_formula(name, *law, [&](const Fad &rate, const Fad &pressure) -> Fad {
    const Fad smooth = sqrt(rate * rate + epsilon * epsilon), I = inertial_number(smooth, pressure);
    const Fad mu = I.val() > I_1 ? grains.mu(I, slope) : Fad(sqrt(alpha / (log_A - log(I))));
    return viscosity + mu * pressure / smooth;
  });
  check(name + ": no yield stress", !law->has_yield_stress());

  bool well_posed = true;
  double jump = 0., previous = 0.;
  for (double I = 1e-9; I < 10.; I *= 1.01)
  {
    const double pressure = 1e6, rate = I * std::sqrt(pressure / double(rho_s)) / double(d_g);
    const double mu = law->viscous_part(rate, pressure).value * rate / pressure;
    well_posed      = well_posed && law->is_well_posed(rate, pressure);
    if (I > 1e-8)
      jump = std::max(jump, std::abs(mu - previous));
    previous = mu;
  }
  check(name + ": well-posed up to I = 10", well_posed);
  check(name + ": friction has no jump", jump, 0.01);
}

/// Hydrostatic up to the level, a height against gravity, whatever gravity's direction is.
void test_pore_water()
{
  const auto wet =
    make_law("mu(I)", {{"Density", "1900"}, {"Pore water level", "-0.5"}, {"Pore water density", "1025"}});
  const PoreWater &water = wet->pore_water();
  const Tensor<1, 3> g({0.6 * 9.81, 0., -0.8 * 9.81});
  const Point<3> deep(0.3, 7., -1.2), high(-2., 7., -1.2);
  check("pore pressure below the level", water.pressure(deep, g) / (1025. * 9.81 * (-0.5 + 0.18 + 0.96)) - 1.,
        1e-14);
  check("... and its gradient", (water.gradient(deep, g) - 1025. * g).norm(), 0.);
  check("no pore pressure above the level", water.pressure(high, g) + water.gradient(high, g).norm(), 0.);
  check("no pore pressure without gravity", water.pressure(deep, Tensor<1, 3>()), 0.);
  check("by default there is no water", !make_law("mu(I)", {})->pore_water().is_there() && water.is_there());
}

void test_refused()
{
  check_refused({{"Drucker-Prager", "Friction angle", "-1"},
                 {"Drucker-Prager", "Friction angle", "90"},
                 {"Drucker-Prager", "Friction angle", "120"},
                 {"Drucker-Prager", "Cohesion", "-1"},
                 {"Drucker-Prager", "Viscosity", "-1"},
                 {"Drucker-Prager", "Regularization parameter", "0"},
                 {"mu(I)", "Grain density", "0"},
                 {"mu(I)", "Grain density", "900"},
                 {"mu(I)", "Grain diameter", "0"},
                 {"mu(I)", "Grain diameter", "-0.001"},
                 {"mu(I)", "Static friction", "0"},
                 {"mu(I)", "Static friction", "1"},
                 {"mu(I)", "Dynamic friction", "0.38"},
                 {"mu(I)", "Dynamic friction", "0.2"},
                 {"mu(I)", "Dynamic friction", "1"},
                 {"mu(I)", "Reference inertial number", "0"},
                 {"mu(I)", "Cohesion", "-1"},
                 {"mu(I)", "Viscosity", "-1"},
                 {"mu(I)", "Regularization parameter", "0"},
                 {"mu(I) Barker-Gray", "Grain diameter", "0"},
                 {"mu(I) Barker-Gray", "Friction slope", "-1"},
                 {"mu(I) Barker-Gray", "Creep exponent", "0"},
                 {"mu(I) Barker-Gray", "Creep exponent", "2"},
                 {"mu(I) Barker-Gray", "Smallest strain rate", "0"},
                 {"mu(I)", "Pore water level", "deep"},
                 {"mu(I)", "Pore water level", "inf"},
                 {"mu(I) Barker-Gray", "Pore water level", "nan"},
                 {"Drucker-Prager", "Pore water level", ""}});
  for (const std::string name : {"Drucker-Prager", "mu(I)", "mu(I) Barker-Gray"})
    for (const std::string density : {"0", "-1", "1500", "2000"})
      check_throws<InputError>(
        name + ": water of the density " + density + " in pores is refused",
        {"'" + name + "/Pore water density'", "'" + density + "'", "Allowed"}, [&] {
          make_law(name, {{"Density", "1500"}, {"Pore water level", "0.3"}, {"Pore water density", density}});
        });
  check_throws<InputError>("Barker-Gray: a friction that is nowhere well-posed is refused",
                           {"'mu(I) Barker-Gray/Dynamic friction'", "'0.381'", "Allowed", "well-posed"}, [] {
                             make_law("mu(I) Barker-Gray", {{"Dynamic friction", "0.381"}});
                           });
}

int main()
{
  test_drucker_prager();
  for (const Grains &grains : all_grains)
  {
    test_mu_of_i(grains);
    test_barker_gray(grains);
  }
  test_pore_water();
  test_refused();
  return n_failed;
}
