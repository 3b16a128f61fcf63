// Test the film of a Bingham-Papanastasiou fluid that its weight drags along a floor (V3, half a plane Poiseuille
// flow): surface speed, mean speed and order of convergence against quadrature of the exact profile.

#include "assembly/stokes.h"

using namespace Tests;

// Units: depth H = 1, weight ρ g = 1 and plastic viscosity μ = 1.
constexpr double tau_0 = 0.25;

/// Rate of shear at height y: the root of τ0 (1 − exp(−m γ̇)) + μ γ̇ = ρ g (H − y), by bisection.
double shear_rate(const double m, const double y)
{
  double lower = 0., upper = 1.;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle                                                  = 0.5 * (lower + upper);
    (-tau_0 * std::expm1(-m * middle) + middle < 1. - y ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

/// Velocity at the heights k/n, by Simpson's rule in each interval.
std::vector<double> exact_profile(const double m, const unsigned int n)
{
  std::vector<double> u(1, 0.);
  for (unsigned int k = 0; k < n; ++k)
    u.push_back(u.back() + (shear_rate(m, double(k) / n) + 4. * shear_rate(m, (k + 0.5) / n) +
                            shear_rate(m, (k + 1.) / n)) /
                             (6. * n));
  return u;
}

struct Result
{
  double surface = 0., mean = 0., l2_error = 0.;
  unsigned int n_iterations = 0;
};

Result compute(const double m, const unsigned int n, const std::vector<double> &exact)
{
  // Squares of two triangles each, their diagonals alternating.
  const unsigned int n_x = 4;
  ParticleCloud<2> cloud;
  for (unsigned int j = 0; j <= n; ++j)
    for (unsigned int i = 0; i <= n_x; ++i)
      cloud.append({double(i) / n, double(j) / n}, j == 0 ? ParticleKind::wall : ParticleKind::fluid, 1. / n);
  std::vector<Simplex<2>> cells;
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n_x; ++i)
    {
      const unsigned int a = j * (n_x + 1) + i, b = a + 1, c = a + n_x + 1, d = c + 1;
      if ((i + j) % 2)
        cells.insert(cells.end(), {{a, b, d}, {a, d, c}});
      else
        cells.insert(cells.end(), {{a, b, c}, {b, d, c}});
    }
  FluidMesh<2> mesh;
  mesh.reinit(cloud, cells);

  // The stabilisation does not see the weight balanced by shear stress; the short time step keeps it small.
  const auto law = make_law("Bingham", {{"Density", "1"},
                                        {"Plastic viscosity", "1"},
                                        {"Yield stress", std::to_string(tau_0)},
                                        {"Regularization parameter", std::to_string(m)}});
  Stokes<2> stokes(mesh, cloud, *law, Point<2>(1., 0.), 1e-4, "");
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
  {
    const Point<2> &x = stokes.state.position[v];
    if (x[1] == 0.)
      stokes.constraints[v].n_fixed = 2;
    else if (x[0] == 0. || x[0] == double(n_x) / n || x[1] == 1.)
    {
      stokes.constraints[v].n_fixed     = 1;
      stokes.constraints[v].frame       = Tensor<2, 2>();
      stokes.constraints[v].frame[0][1] = stokes.constraints[v].frame[1][0] = 1.;
    }
  }
  Result result;
  result.n_iterations = stokes.solve(ViscosityLinearization::picard, 1e-9, 400);

  // Along the middle column: the profile at the nodes is joined by straight lines.
  const unsigned int refinement = (exact.size() - 1) / n;
  const auto u = [&](const unsigned int j) { return stokes.state.velocity[j * (n_x + 1) + n_x / 2][0]; };
  for (unsigned int j = 0; j < n; ++j)
  {
    result.mean += 0.5 * (u(j) + u(j + 1)) / n;
    for (unsigned int k = 0; k < refinement; ++k)
    {
      const double t         = (k + 0.5) / refinement,
                   reference = 0.5 * (exact[j * refinement + k] + exact[j * refinement + k + 1]);
      result.l2_error += std::pow((1. - t) * u(j) + t * u(j + 1) - reference, 2) / (n * refinement);
    }
  }
  result.l2_error = std::sqrt(result.l2_error);
  result.surface  = u(n);
  return result;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Speed at the surface and mean speed from shared/data/bingham_plane_poiseuille.csv of the project (phi = 0.25),
  // computed independently by quadrature: u_centre and u_mean for M = m G H/mu.
  struct Case
  {
    double m, surface, mean;
  };
  for (const Case &c : {Case{100., 0.28375, 0.2114313}, Case{1000., 0.2815, 0.2109846}})
  {
    std::cout << "M = " << c.m << std::endl;
    const std::vector<double> exact = exact_profile(c.m, 3200);
    double mean                     = 0.;
    for (unsigned int k = 0; k < 3200; ++k)
      mean += 0.5 * (exact[k] + exact[k + 1]) / 3200.;
    check("quadrature gives the table's surface speed", exact.back() / c.surface - 1., 1e-5);
    check("quadrature gives the table's mean speed", mean / c.mean - 1., 1e-5);
    check("surface speed tends to the Bingham film's (1 - h_c)^2/2",
          exact.back() - 0.5 * std::pow(1. - tau_0, 2), 0.26 / c.m);

    std::vector<Result> results;
    for (const unsigned int n : {8, 16, 32})
    {
      results.push_back(compute(c.m, n, exact));
      check("converged", results.back().n_iterations < 400);
    }
    check("surface speed with 16 cells", results[1].surface / c.surface - 1., 0.01);
    check("mean speed with 16 cells", results[1].mean / c.mean - 1., 0.01);
    check("surface speed with 32 cells", results[2].surface / c.surface - 1., 0.0025);
    const double order = 0.5 * std::log2(results[0].l2_error / results[2].l2_error);
    check("order of convergence about 2", order - 2., 0.25);
    if (std::getenv("LAHAR_TEST_VERBOSE"))
      for (const Result &r : results)
        std::cout << r.surface / c.surface - 1. << ' ' << r.mean / c.mean - 1. << ' ' << r.l2_error << ' '
                  << r.n_iterations << '\n';
  }
  return n_failed;
}
