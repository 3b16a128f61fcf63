// SPDX-License-Identifier: GPL-3.0-or-later

// Test the film of a Bingham-Papanastasiou fluid that its weight drags along a floor (V3, half a plane Poiseuille
// flow): surface speed, mean speed and order of convergence against quadrature of the exact profile, in the plane and
// in space, where the film flows between two slip walls.

#include "assembly/film.h"
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

/// No velocity on the floor, none upwards elsewhere on the boundary, none across the flow on the sides in space.
template <int dim>
NodeConstraint<dim> constraint(const Point<dim> &x, const double length)
{
  const auto is_end = [&](const unsigned int d) { return x[d] == 0. || x[d] == length; };
  NodeConstraint<dim> result;
  if (x[dim - 1] == 0.)
  {
    result.n_fixed = dim;
    return result;
  }
  result.frame = Tensor<2, dim>();
  std::array<bool, dim> is_fixed{};
  is_fixed[dim - 1] = is_end(0) || x[dim - 1] == 1.;
  if (dim == 3)
    is_fixed[1] = is_end(0) || is_end(1);
  for (unsigned int d = 0; d < dim; ++d)
    if (is_fixed[d])
      result.frame[result.n_fixed++][d] = 1.;
  for (unsigned int d = 0, row = result.n_fixed; d < dim; ++d)
    if (!is_fixed[d])
      result.frame[row++][d] = 1.;
  return result;
}

template <int dim>
Result compute(const double m, const unsigned int n, const std::vector<double> &exact)
{
  const unsigned int n_wide = (dim == 2 ? 4 : 2);
  Film<dim> film(n, n_wide);
  FluidMesh<dim> mesh;
  mesh.reinit(film.cloud, film.cells);

  // The stabilisation does not see the weight balanced by shear stress; the short time step keeps it small.
  const auto law = make_law("Bingham", {{"Density", "1"},
                                        {"Plastic viscosity", "1"},
                                        {"Yield stress", std::to_string(tau_0)},
                                        {"Regularization parameter", std::to_string(m)}});
  Tensor<1, dim> gravity;
  gravity[0] = 1.;
  Stokes<dim> stokes(mesh, film.cloud, *law, gravity, 1e-4, "");
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    stokes.constraints[v] = constraint<dim>(stokes.state.position[v], double(n_wide) / n);
  Result result;
  result.n_iterations = stokes.solve(ViscosityLinearization::picard, 1e-9, 400);

  // Along the column in the middle: the profile at the nodes is joined by straight lines.
  const unsigned int refinement = (exact.size() - 1) / n;
  std::vector<double> u(n + 1);
  for (unsigned int v = 0; v < stokes.system.partition().n_own(); ++v)
    if (stokes.mesh.particle(v) % film.layer_size() == film.layer_size() / 2)
      u[stokes.mesh.particle(v) / film.layer_size()] = stokes.state.velocity[v][0];
  Utilities::MPI::sum(u, MPI_COMM_WORLD, u);
  for (unsigned int j = 0; j < n; ++j)
  {
    result.mean += 0.5 * (u[j] + u[j + 1]) / n;
    for (unsigned int k = 0; k < refinement; ++k)
    {
      const double t         = (k + 0.5) / refinement,
                   reference = 0.5 * (exact[j * refinement + k] + exact[j * refinement + k + 1]);
      result.l2_error += std::pow((1. - t) * u[j] + t * u[j + 1] - reference, 2) / (n * refinement);
    }
  }
  result.l2_error = std::sqrt(result.l2_error);
  result.surface  = u[n];
  return result;
}

/// Speed at the surface and mean speed from shared/data/bingham_plane_poiseuille.csv of the project (phi = 0.25),
/// computed independently by quadrature: u_centre and u_mean for M = m G H/mu.
struct Case
{
  double m, surface, mean;
};

template <int dim>
void test(const Case &c, const std::vector<double> &exact)
{
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "dim = " << dim << ", M = " << c.m << std::endl;
  std::vector<Result> results;
  for (const unsigned int n : {8, 16, 32})
  {
    results.push_back(compute<dim>(c.m, n, exact));
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

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const Case &c : {Case{100., 0.28375, 0.2114313}, Case{1000., 0.2815, 0.2109846}})
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << "M = " << c.m << std::endl;
    const std::vector<double> exact = exact_profile(c.m, 3200);
    double mean                     = 0.;
    for (unsigned int k = 0; k < 3200; ++k)
      mean += 0.5 * (exact[k] + exact[k + 1]) / 3200.;
    check("quadrature gives the table's surface speed", exact.back() / c.surface - 1., 1e-5);
    check("quadrature gives the table's mean speed", mean / c.mean - 1., 1e-5);
    check("surface speed tends to the Bingham film's (1 - h_c)^2/2",
          exact.back() - 0.5 * std::pow(1. - tau_0, 2), 0.26 / c.m);
    test<2>(c, exact);
    test<3>(c, exact);
  }
  return n_failed;
}
