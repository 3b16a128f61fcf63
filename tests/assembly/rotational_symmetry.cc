// SPDX-License-Identifier: GPL-3.0-or-later

// Test rotational symmetry on unstructured meshes that reach to the axis: volumes, a uniform extension that is met to
// rounding, fluid at rest in a cylinder with its weight on the floor, and the flow of Newtonian and Bingham fluids
// through a pipe with its order of convergence.

#include <deal.II/base/utilities.h>

#include <lahar/geometry/polygon.h>
#include <lahar/geometry/polygon_body.h>
#include <lahar/geometry/symmetry.h>

#include <limits>

#include "assembly/stokes.h"

using namespace Tests;

/// No radial velocity, and no axial one if @p all.
NodeConstraint<2> fixed(const bool all)
{
  NodeConstraint<2> result;
  result.n_fixed = all ? 2 : 1;
  return result;
}

void check_extension()
{
  const Polygon polygon = {{0., 0.}, {1., 0.}, {1.2, 0.5}, {0.5, 0.5}, {0.5, 1.}, {0., 1.}};
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  mesh_polygon(polygon, 0.1, cloud, mesh);
  // A frustum with the radii 1 and 1.2, and a cylinder.
  const double volume = numbers::PI * (0.5 * (1. + 1.2 + 1.44) / 3. + 0.125);
  check("volume of the mesh", mesh.volume(cloud) - volume, 1e-12);
  check("volume of the body", PolygonBody("body", polygon).volume() - volume, 1e-12);

  const auto newtonian = make_law("Newtonian",
                                  {{"Density", "1"}, {"Bulk modulus", "10"}, {"Viscosity", "2"}});
  const auto bingham   = make_law("Bingham", {{"Density", "1"},
                                              {"Bulk modulus", "10"},
                                              {"Plastic viscosity", "1"},
                                              {"Yield stress", "3"},
                                              {"Regularization parameter", "5"}});
  for (const std::string form : {"projected residual", "residual", "FIC interior"})
    for (const FluidLaw *law : {newtonian.get(), bingham.get()})
    {
      Stokes<2> stokes(mesh, cloud, *law, Tensor<1, 2>(), 1.,
                       "subsection Stabilization\n set Form = " + form + "\nend\n");
      const auto exact = [](const Point<2> &x) { return Tensor<1, 2>({0.7 * x[0], 0.3 - 1.4 * x[1]}); };
      for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
        if (cloud.kind[stokes.mesh.particle(v)] == ParticleKind::wall)
        {
          const Point<2> &x     = stokes.state.position[v];
          const bool is_axis    = x[0] == 0. && x[1] > 0. && x[1] < 1.;
          stokes.constraints[v] = fixed(!is_axis);
          if (!is_axis)
            stokes.state.velocity[v] = exact(x);
        }
      if (law == bingham.get())
        stokes.solve(ViscosityLinearization::picard, 1e-3, 100);
      const unsigned int n_iterations = stokes.solve(ViscosityLinearization::newton, 1e-12, 20);
      double error = 0., pressure = 0.;
      for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
      {
        error    = std::max(error, (stokes.state.velocity[v] - exact(stokes.state.position[v])).norm());
        pressure = std::max(pressure, std::abs(stokes.state.pressure[v]));
      }
      const std::string name = (law == newtonian.get() ? "Newtonian, " : "Bingham, ") + form;
      check(name + ": uniform extension", error, 1e-10);
      check(name + ": no pressure", pressure, 1e-9);
      check(name + ": converged", n_iterations <= 8);
    }
}

void check_rest()
{
  const Polygon polygon = {{0., 0.}, {1., 0.}, {1., 0.7}, {0., 0.7}};
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  mesh_polygon(polygon, 0.1, cloud, mesh);
  const auto law = make_law("Newtonian", {{"Density", "2"}, {"Viscosity", "0.1"}});
  Stokes<2> stokes(mesh, cloud, *law, Tensor<1, 2>({0., -3.}), 1e-3, "");
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    if (const Point<2> &x = stokes.state.position[v]; x[1] == 0. || x[0] == 0. || x[0] == 1.)
      stokes.constraints[v] = fixed(x[1] == 0.);
  stokes.solve(ViscosityLinearization::newton, 1e-12, 20);
  stokes.assemble(ViscosityLinearization::newton);
  double error = 0., speed = 0., on_floor = 0.;
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
  {
    const Point<2> &x = stokes.state.position[v];
    error             = std::max(error, std::abs(stokes.state.pressure[v] + 6. * (0.7 - x[1])));
    speed             = std::max(speed, stokes.state.velocity[v].norm());
    if (const LocalNode node = stokes.system.local_number(Vertex(v));
        x[1] == 0. && stokes.system.partition().is_own(node))
      on_floor += stokes.system.momentum_residual()[node][1];
  }
  check("pressure of fluid at rest", error, 1e-9);
  check("it is at rest", speed, std::numeric_limits<double>::epsilon() / Stokes<2>::motion_step);
  check("its weight is on the floor", Utilities::MPI::sum(on_floor, MPI_COMM_WORLD) - 6. * 0.7 * numbers::PI,
        1e-8);
}

/// Rate of shear where the shear stress is @p stress: μ = 1, τ0 and m of the law.
double shear_rate(const double tau_0, const double m, const double stress)
{
  double lower = 0., upper = 10.;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle                                                  = 0.5 * (lower + upper);
    (-tau_0 * std::expm1(-m * middle) + middle < stress ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

/// Velocity at the radius @p r of a pipe of radius 1 under the load 4 per volume, so that the shear stress is 2 r.
double pipe_velocity(const double tau_0, const double m, const double r)
{
  constexpr unsigned int n = 200; // Simpson
  double sum               = 0.;
  for (unsigned int k = 0; k <= n; ++k)
    sum += (k == 0 || k == n ? 1. : k % 2 ? 4. : 2.) * shear_rate(tau_0, m, 2. * (r + k * (1. - r) / n));
  return sum * (1. - r) / (3. * n);
}

double pipe_error(const double tau_0, const double m, const unsigned int n)
{
  const Polygon polygon = {{0., 0.}, {1., 0.}, {1., 0.4}, {0., 0.4}};
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  mesh_polygon(polygon, 1. / n, cloud, mesh);
  const auto law = make_law("Bingham", {{"Density", "1"},
                                        {"Plastic viscosity", "1"},
                                        {"Yield stress", std::to_string(tau_0)},
                                        {"Regularization parameter", std::to_string(m)}});
  // The stabilisation does not see the weight balanced by shear stress; the short time step keeps it small.
  Stokes<2> stokes(mesh, cloud, *law, Tensor<1, 2>({0., 4.}), 1e-4, "");
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    if (const Point<2> &x = stokes.state.position[v];
        cloud.kind[stokes.mesh.particle(v)] == ParticleKind::wall)
      stokes.constraints[v] = fixed(x[0] == 1.);
  stokes.solve(ViscosityLinearization::picard, 1e-3, 200);
  stokes.solve(ViscosityLinearization::newton, 1e-11, 30);
  double sum = 0., size = 0.;
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
  {
    const Point<2> &x = stokes.state.position[v];
    const double u    = pipe_velocity(tau_0, m, x[0]);
    sum += (stokes.state.velocity[v] - Tensor<1, 2>({0., u})).norm_square();
    size += u * u;
  }
  return std::sqrt(Utilities::MPI::sum(sum, MPI_COMM_WORLD) / Utilities::MPI::sum(size, MPI_COMM_WORLD));
}

void check_pipe(const std::string &name, const double tau_0, const double m)
{
  const double coarse = pipe_error(tau_0, m, 10), medium = pipe_error(tau_0, m, 20),
               fine = pipe_error(tau_0, m, 40);
  check(name + " through a pipe: error at 40 cells", fine, 1.5e-3);
  const double order = std::log2(coarse / fine) / 2.;
  check(name + " through a pipe: second order", order > 1.8);
  if (!(order > 1.8) || !(fine < 1.5e-3))
    std::cout << "    errors " << coarse << ", " << medium << ", " << fine << std::endl;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Symmetry::set_rotational(true);
  check_extension();
  check_rest();
  check_pipe("Newtonian fluid", 0., 1.);
  check_pipe("Bingham fluid", 0.6, 20.);
  return n_failed;
}
