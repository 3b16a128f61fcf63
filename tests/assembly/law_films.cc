// SPDX-License-Identifier: GPL-3.0-or-later

// Test films of fluids of all laws that their weight drags along a floor: the speed of the surface and the mean speed
// against the exact ones, and the order of convergence.

#include <functional>
#include <iomanip>
#include <sstream>

#include "assembly/film.h"
#include "assembly/stokes.h"

using namespace Tests;

/// Units: depth H = 1 and weight ρ g = 1, so that the stress at the depth s below the surface is s.
struct Case
{
  std::string law;
  Entries entries;
  std::function<double(double)> rate; ///< of the law without regularisation, for a stress
};

/// The surface's speed ∫ γ̇ ds and the mean speed ∫ γ̇ s ds over the stresses s from 0 to 1, by the midpoint rule.
std::pair<double, double> exact_speeds(const Case &c)
{
  const unsigned int n = 100000;
  double surface = 0., mean = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double stress = (i + 0.5) / n;
    surface += c.rate(stress) / n;
    mean += stress * c.rate(stress) / n;
  }
  return {surface, mean};
}

/// The strain rate at which the growing function @p stress_of is @p stress, by bisection.
double inverse(const std::function<double(double)> &stress_of, const double stress)
{
  double lower = 0., upper = 1e4;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle                          = 0.5 * (lower + upper);
    (stress_of(middle) < stress ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

/// Speeds of the surface and in the mean with @p n cells over the depth.
std::pair<double, double> compute(const FluidLaw &law, const unsigned int n, bool &converged)
{
  const unsigned int n_wide = 4;
  Film<2> film(n, n_wide);
  FluidMesh<2> mesh;
  mesh.reinit(film.cloud, film.cells);
  // The stabilisation does not see the weight balanced by shear stress; the short time step keeps it small.
  Stokes<2> stokes(mesh, film.cloud, law, Point<2>(1., 0.), 1e-4, "");
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
  {
    // No velocity on the floor, none upwards elsewhere on the boundary.
    const Point<2> &x        = stokes.state.position[v];
    NodeConstraint<2> &fixed = stokes.constraints[v];
    if (x[1] == 0.)
      fixed.n_fixed = 2;
    else if (x[0] == 0. || x[0] == double(n_wide) / n || x[1] == 1.)
    {
      fixed.n_fixed = 1;
      fixed.frame   = Tensor<2, 2>({{0., 1.}, {1., 0.}});
    }
  }
  converged = converged && stokes.solve(ViscosityLinearization::picard, 1e-9, 600) < 600;
  std::vector<double> u(n + 1);
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    if (stokes.mesh.particle(v) % film.layer_size() == film.layer_size() / 2)
      u[stokes.mesh.particle(v) / film.layer_size()] = stokes.state.velocity[v][0];
  double mean = 0.;
  for (unsigned int j = 0; j < n; ++j)
    mean += 0.5 * (u[j] + u[j + 1]) / n;
  return {u[n], mean};
}

void test(const std::string &name, const Case &c)
{
  Entries entries = c.entries;
  entries.emplace_back("Density", "1");
  const auto law                         = make_law(c.law, entries);
  const auto [exact_surface, exact_mean] = exact_speeds(c);
  bool converged                         = true;
  std::vector<std::pair<double, double>> errors;
  for (const unsigned int n : {8, 16, 32})
  {
    const auto [surface, mean] = compute(*law, n, converged);
    errors.emplace_back(surface / exact_surface - 1., mean / exact_mean - 1.);
  }
  check(name + ": converged", converged);
  check(name + ": surface speed with 16 cells", errors[1].first, 5e-3);
  check(name + ": mean speed with 16 cells", errors[1].second, 5e-3);
  check(name + ": a third of the error with twice as many, or a thousandth",
        std::max(std::abs(errors[2].first), std::abs(errors[2].second)) <
          std::max(1e-3, std::max(std::abs(errors[1].first), std::abs(errors[1].second)) / 3.));
  if (std::getenv("LAHAR_TEST_VERBOSE"))
    for (const auto &[surface, mean] : errors)
      std::cout << surface << ' ' << mean << '\n';
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double tau_0 = 0.25, K = 0.5;
  for (const double n : {0.4, 1., 1.5})
  {
    std::ostringstream index;
    index << n;
    const Entries entries = {{"Consistency", "0.5"}, {"Flow index", index.str()}};
    Case c{"power law", entries, [=](const double s) { return std::pow(s / K, 1. / n); }};
    test("power law n = " + index.str(), c);
    const auto [surface, mean] = exact_speeds(c);
    check("... the closed forms",
          std::abs(surface / (n / (n + 1.) * std::pow(K, -1. / n)) - 1.) +
            std::abs(mean / (n / (2. * n + 1.) * std::pow(K, -1. / n)) - 1.),
          1e-6);
    c.law = "Herschel-Bulkley";
    c.entries.emplace_back("Yield stress", "0.25");
    c.rate = [=](const double s) { return s < tau_0 ? 0. : std::pow((s - tau_0) / K, 1. / n); };
    test("Herschel-Bulkley n = " + index.str(), c);
    check("... the closed form",
          exact_speeds(c).first / (n / (n + 1.) * std::pow(K, -1. / n) * std::pow(1. - tau_0, 1. + 1. / n)) -
            1.,
          1e-6);
  }

  const double root = std::sqrt(tau_0);
  // Casson's fluid flows so slowly above the yield stress that the default regularisation would change it by 1.5e-3.
  const Case casson{"Casson",
                    {{"Casson viscosity", "0.5"},
                     {"Yield stress", "0.25"},
                     {"Regularization parameter", "10000"}},
                    [=](const double s) { return s < tau_0 ? 0. : std::pow(std::sqrt(s) - root, 2) / K; }};
  test("Casson", casson);
  check("... the closed form",
        exact_speeds(casson).first /
            ((0.5 * (1. - tau_0 * tau_0) - 4. / 3. * root * (1. - std::pow(root, 3)) + tau_0 * (1. - tau_0)) /
             K) -
          1.,
        1e-6);

  const auto carreau = [](const double rate) {
    return rate * (0.05 + 0.95 * std::pow(1. + std::pow(2. * rate, 1.5), -0.4));
  };
  test("Carreau-Yasuda", {"Carreau-Yasuda",
                          {{"Viscosity at rest", "1"},
                           {"Viscosity at high rates", "0.05"},
                           {"Time constant", "2"},
                           {"Flow index", "0.4"},
                           {"Exponent of the bend", "1.5"}},
                          [&](const double s) { return inverse(carreau, s); }});
  const auto cross = [](const double rate) { return rate * (0.05 + 0.95 / (1. + std::pow(2. * rate, 0.7))); };
  test("Cross", {"Cross",
                 {{"Viscosity at rest", "1"},
                  {"Viscosity at high rates", "0.05"},
                  {"Time constant", "2"},
                  {"Exponent", "0.7"}},
                 [&](const double s) { return inverse(cross, s); }});
  return n_failed;
}
