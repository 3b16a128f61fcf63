// SPDX-License-Identifier: GPL-3.0-or-later

// Test films of grains that their weight drags down an incline: Bagnold's profile of mu(I) and the films of Drucker and
// Prager's fluid against the exact speeds and pressures, dry and under still water, the orders of convergence, the angle at
// which a film starts, and Newton's convergence with the derivative with respect to the pressure.

#include "assembly/film.h"
#include "assembly/stokes.h"

using namespace Tests;

/// Still water around the film and in its pores, of 0.4 of the film's density, up to 1.5 above the origin; or none.
constexpr double water_density = 0.4, water_level = 1.5;

Entries under_water(Entries entries)
{
  entries.insert(entries.end(), {{"Pore water density", std::to_string(water_density)},
                                 {"Pore water level", std::to_string(water_level)}});
  return entries;
}

/// Units: depth H = 1, density ρ = 1, gravity g = 1, of which sin θ drags along the floor.
struct Flow
{
  double surface = 0., mean = 0., pressure_error = 0.; ///< speeds of the surface and in the mean
  unsigned int newton_iterations = 0;
  bool converged                 = false; ///< Picard's iteration
};

constexpr unsigned int max_iterations = 4000, max_newton_iterations = 6;

/// @param law also says whether there is water. @param with_newton whether Newton's method follows Picard's, from a state
/// that is a tenth away from the solution.
Flow compute(const FluidLaw &law, const double angle, const unsigned int n, const bool with_newton)
{
  const unsigned int n_wide = n / 2;
  Film<2> film(n, n_wide);
  FluidMesh<2> mesh;
  mesh.reinit(film.cloud, film.cells);
  // The stabilisation does not see the weight balanced by shear stress; the short time step keeps it small.
  Stokes<2> stokes(mesh, film.cloud, law, Point<2>(std::sin(angle), -std::cos(angle)), 3e-5, "");
  const double h = 1. / n, width = n_wide * h;
  // Around it and in its pores the water's pressure, which carries its share of the weight. At both ends the film goes on:
  // the exact stress.
  const double rho          = law.pore_water().is_there() ? 1. - water_density : 1.;
  const auto water_pressure = [&](const Point<2> &x) {
    return (1. - rho) * (water_level + std::sin(angle) * x[0] - std::cos(angle) * x[1]);
  };
  const auto exact_pressure = [&](const Point<2> &x) {
    return -rho * std::cos(angle) * (1. - x[1]) - water_pressure(x);
  };
  const auto exact_stress = [&](const Point<2> &x) {
    return Point<2>(exact_pressure(x), rho * std::sin(angle) * (1. - x[1]));
  };
  stokes.forces.resize(stokes.mesh.n_vertices());
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
  {
    const Point<2> &place = stokes.places[v];
    const double x = place[0], y = place[1];
    if (y == 0.)
      stokes.constraints[v].n_fixed = 2;
    else if (x == 0. || x == width)
      for (const double neighbour : {y - h, y + h})
        if (neighbour < 1. + h / 2.)
          stokes.forces[v] += (x == 0. ? -1. : 1.) * h / 6. *
                              (2. * exact_stress(place) + exact_stress(Point<2>(x, neighbour)));
    if (y == 1.)
      for (const double neighbour : {x - h, x + h})
        if (neighbour > -h / 2. && neighbour < width + h / 2.)
          stokes.forces[v][1] -= h / 6. *
                                 (2. * water_pressure(place) + water_pressure(Point<2>(neighbour, y)));
    // Where to start from: without pressure there would be neither friction nor viscosity.
    stokes.state.pressure[v] = 0.5 * exact_pressure(place) - 0.5 * water_pressure(place);
  }
  Flow flow;
  flow.converged = stokes.solve(ViscosityLinearization::picard, 1e-8, max_iterations) < max_iterations;
  if (with_newton)
  {
    for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    {
      stokes.state.velocity[v] *= 0.9;
      stokes.state.pressure[v] *= 1.1;
    }
    flow.newton_iterations = stokes.solve(ViscosityLinearization::newton, 1e-6, max_newton_iterations + 1);
  }

  std::vector<double> u(n + 1);
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    if (const unsigned int particle = stokes.mesh.particle(v);
        particle % film.layer_size() == film.layer_size() / 2)
    {
      u[particle / film.layer_size()] = stokes.state.velocity[v][0];
      flow.pressure_error             = std::max(flow.pressure_error,
                                                 std::abs(stokes.state.pressure[v] - exact_pressure(stokes.places[v])));
    }
  flow.surface = u[n];
  for (unsigned int j = 0; j < n; ++j)
    flow.mean += 0.5 * (u[j] + u[j + 1]) / n;
  return flow;
}

/// With four times as many cells the errors of the speeds fall by more than @p reduction.
void test(const std::string &name, const FluidLaw &law, const double angle, const double surface,
          const double mean, const double reduction)
{
  std::vector<double> errors, pressure_errors;
  bool converged                 = true;
  unsigned int newton_iterations = 0;
  for (const unsigned int n : {8, 16, 32})
  {
    const Flow flow   = compute(law, angle, n, true);
    converged         = converged && flow.converged;
    newton_iterations = std::max(newton_iterations, flow.newton_iterations);
    errors.push_back(std::max(std::abs(flow.surface / surface - 1.), std::abs(flow.mean / mean - 1.)));
    pressure_errors.push_back(flow.pressure_error);
    if (std::getenv("LAHAR_TEST_VERBOSE"))
      std::cout << n << ": speeds " << flow.surface / surface - 1. << ' ' << flow.mean / mean - 1.
                << ", pressure " << flow.pressure_error << ", Newton iterations " << flow.newton_iterations
                << std::endl;
  }
  check(name + ": Picard's iteration converged", converged);
  check(name + ": Newton's method finds the same from near by", newton_iterations <= max_newton_iterations);
  check(name + ": speeds with 16 cells", errors[1], 3e-3);
  check(name + ": order of convergence of the speeds", errors[0] > reduction * errors[2]);
  // What does not yield bears any pressure within its yield stress.
  if (!(law.yield_stress(0.).value > 0.))
    check(name + ": pressure with 16 cells", pressure_errors[1], 0.01);
}

void test_bagnold()
{
  const double mu_s = 0.38, mu_d = 0.64, I_0 = 0.279, part = 0.6, d_g = 0.02;
  const Entries entries = {{"Density", "1"},
                           {"Grain density", "1.6666666666666667"},
                           {"Grain diameter", "0.02"},
                           {"Static friction", "0.38"},
                           {"Dynamic friction", "0.64"},
                           {"Reference inertial number", "0.279"},
                           {"Viscosity", "1e-8"},
                           {"Regularization parameter", "1e6"}};
  // On the way to the solution the uppermost cells may have no pressure but the water's.
  Entries submerged = under_water(entries);
  submerged.push_back({"Viscosity", "1e-6"});
  const auto dry = make_law("mu(I)", entries), wet = make_law("mu(I)", submerged);
  for (const double angle : {24., 28.})
  {
    const double theta = angle * numbers::PI / 180., slope = std::tan(theta);
    const double I         = I_0 * (slope - mu_s) / (mu_d - slope);
    const double speed     = I / d_g * std::sqrt(part * std::cos(theta)); // times sqrt(g H³)
    const std::string name = "Bagnold's film at " + std::to_string(int(angle)) + " degrees";
    test(name, *dry, theta, 2. / 3. * speed, 2. / 5. * speed, 2.);
    // The same inertial number, less pressure.
    const double slower = std::sqrt(1. - water_density) * speed;
    if (angle == 24.)
      test(name + " under water", *wet, theta, 2. / 3. * slower, 2. / 5. * slower, 2.);
  }
}

void test_drucker_prager()
{
  const double friction = 0.5;
  for (const double cohesion : {0., 0.1})
  {
    const Entries entries  = {{"Density", "1"},
                              {"Cohesion", std::to_string(cohesion)},
                              {"Friction angle", "30"},
                              {"Viscosity", "0.1"},
                              {"Regularization parameter", "1e6"}};
    const auto law         = make_law("Drucker-Prager", entries);
    const std::string name = cohesion > 0. ? "film with friction and cohesion" : "film with friction";
    // What drags beyond friction; the plug that cohesion holds.
    const double theta = 0.7, drag = std::sin(theta) - friction * std::cos(theta),
                 sheared = 1. - cohesion * std::cos(numbers::PI / 6.) / drag,
                 surface = drag * sheared * sheared / (2. * 0.1);
    test(name, *law, theta, surface, surface * (1. - sheared / 3.), 9.);
    const double slower = (1. - water_density) * surface;
    if (cohesion == 0.)
      test(name + " under water", *make_law("Drucker-Prager", under_water(entries)), theta, slower,
           slower * (1. - sheared / 3.), 9.);
  }

  // Without cohesion it starts at tan θ = sin φ, dry or under water.
  for (const bool is_wet : {false, true})
  {
    const Entries entries = {{"Density", "1"},
                             {"Friction angle", "30"},
                             {"Viscosity", "0.01"},
                             {"Regularization parameter", "1e6"}};
    const auto law        = make_law("Drucker-Prager", is_wet ? under_water(entries) : entries);
    const double rho = is_wet ? 1. - water_density : 1., below = std::atan(0.99 * friction),
                 above = std::atan(1.03 * friction),
                 speed = rho * (std::sin(above) - friction * std::cos(above)) / (2. * 0.01);
    const Flow creep = compute(*law, below, 16, false), flow = compute(*law, above, 16, false);
    const std::string film = is_wet ? "a film under water" : "a film";
    check(film + " below the angle of friction creeps", creep.surface, 1e-5);
    check(film + " above it flows", flow.surface / speed - 1., 5e-3);
    check("... and both have converged", creep.converged && flow.converged);
  }
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_bagnold();
  test_drucker_prager();
  return n_failed;
}
