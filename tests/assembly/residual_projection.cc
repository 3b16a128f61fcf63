// SPDX-License-Identifier: GPL-3.0-or-later

// Test that the stabilisation sees no error in fluid whose shear stress carries its weight: in a film with the exact
// profile the projected residual is the divergence of the stress, and the mass residual vanishes; without projection
// it does not. Where there is no stress, nothing is projected.

#include <lahar/assembly/residual_projection.h>

#include "assembly/film.h"
#include "assembly/stokes.h"

using namespace Tests;

/// Largest flow in the mass equations of @p form, over what crosses one cell's face at the film's surface speed.
template <int dim>
double mass_residual(const Film<dim> &film, const FluidMesh<dim> &mesh, const FluidLaw &law,
                     const Tensor<1, dim> &weight, const std::string &form)
{
  const double time_step = 1e-2;
  Stokes<dim> stokes(mesh, film.cloud, law, weight, time_step,
                     "subsection Stabilization\n set Form = " + form + "\nend\n");
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
  {
    const double y              = stokes.state.position[v][dim - 1];
    stokes.state.velocity[v][0] = y * (1. - 0.5 * y);
  }
  stokes.set_stabilization();
  stokes.prescribe();
  stokes.assemble(ViscosityLinearization::picard);
  double largest = 0.;
  for (const double flow : stokes.system.pressures(stokes.system.right_hand_side()))
    largest = std::max(largest, std::abs(flow));
  return largest / (0.5 * std::pow(1. / film.n, dim - 1));
}

template <int dim>
void test()
{
  // Depth, weight and viscosity are 1; the film's speed is y (1 − y/2), its shear stress 1 − y.
  const unsigned int n = 8;
  Film<dim> film(n, 4);
  FluidMesh<dim> mesh;
  mesh.reinit(film.cloud, film.cells);
  const auto law = make_law("Newtonian", {{"Density", "1"}, {"Viscosity", "1"}});
  Tensor<1, dim> weight;
  weight[0] = 1.;

  Stokes<dim> stokes(mesh, film.cloud, *law, weight, 1e-2, "");
  const auto project = [&](const double speed, const std::vector<double> &pressure) {
    for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    {
      const double y           = film.cloud.position[mesh.particle(v)][dim - 1];
      stokes.state.velocity[v] = speed * y * (1. - 0.5 * y) * weight;
    }
    stokes.state.pressure = pressure;
    ResidualProjection<dim> projection(mesh.n_vertices());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      projection.add(mesh.cells()[c], {stokes.state, c, mesh.cells()[c], 0, *law, false});
    return projection.compute();
  };

  const std::vector<double> no_pressure(mesh.n_vertices(), 0.);
  double error = 0., below = 1., above = 0.;
  const auto divergence = project(1., no_pressure);
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    if (film.cloud.position[mesh.particle(v)][dim - 1] < 1.)
      error = std::max(error, (divergence[v] - weight).norm());
    else
    {
      // The stress is small in all cells here and limits the projection.
      below = std::min(below, divergence[v].norm());
      above = std::max(above, divergence[v].norm());
    }
  check("projection is minus the divergence of the stress", error, 1e-12);
  check("at the surface it is not far below and not above that", below > 0.85 && above < 1. + 1e-12);

  double at_rest = 0.;
  for (const Tensor<1, dim> &pi : project(0., no_pressure))
    at_rest = std::max(at_rest, pi.norm());
  check("projection without stress", at_rest, 1e-14);

  // One impact at one particle.
  std::vector<double> impact    = no_pressure;
  impact[mesh.n_vertices() / 2] = 1e6;
  double with_impact            = 0.;
  for (const Tensor<1, dim> &pi : project(1., impact))
    with_impact = std::max(with_impact, pi.norm());
  check("the stress limits what an impact leaves", with_impact < 2. * n);

  const double projected = mass_residual(film, mesh, *law, weight, "projected residual"),
               plain     = mass_residual(film, mesh, *law, weight, "residual");
  std::cout << "Flow in the mass equations: projected " << projected << ", plain " << plain << std::endl;
  check("the projection takes away the flow that stress drives", projected < 0.1 * plain);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  return n_failed;
}
