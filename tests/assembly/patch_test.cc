// SPDX-License-Identifier: GPL-3.0-or-later

// Test that linear velocity fields pass the patch test (V2) on unstructured meshes in 2D and 3D for all forms of the
// stabilisation and both laws, and that rigid motions make neither strain nor residual.

#include <deal.II/base/utilities.h>

#include <lahar/geometry/polygon.h>
#include <lahar/geometry/simplex_geometry.h>

#include "assembly/stokes.h"

using namespace Tests;

/// An L with a skew side; the boundary's particles count as walls, so that no face is a free surface.
void make_mesh(ParticleCloud<2> &cloud, FluidMesh<2> &mesh)
{
  const Polygon polygon = {{0., 0.}, {1., 0.}, {1.2, 0.5}, {0.5, 0.5}, {0.5, 1.}, {0., 1.}};
  mesh_polygon(polygon, 0.1, cloud, mesh);
  check("2D mesh fills the polygon", mesh.volume(cloud) - signed_area(polygon), 1e-12);
}

/// A cube with shaken inner particles.
void make_mesh(ParticleCloud<3> &cloud, FluidMesh<3> &mesh)
{
  Random random;
  const unsigned int n = 4;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int k = 0; k <= n; ++k)
      {
        const bool inside        = std::min({i, j, k}) > 0 && std::max({i, j, k}) < n;
        const Tensor<1, 3> shift = 0.2 * random.vector<3>();
        cloud.append((Point<3>(i, j, k) + (inside ? shift : Tensor<1, 3>())) / n,
                     inside ? ParticleKind::fluid : ParticleKind::wall, 1. / n);
      }
  std::vector<Simplex<3>> cells;
  for (const Simplex<3> &simplex : delaunay(cloud.position))
    if (signed_volume<3>(corners_of<3>(simplex, cloud.position)) > 1e-8)
      cells.push_back(simplex);
  mesh.reinit(cloud, cells);
  check("3D mesh fills the cube", mesh.volume(cloud) - 1., 1e-12);
}

template <int dim>
double velocity_error(const Stokes<dim> &stokes, const Tensor<2, dim> &L, const Tensor<1, dim> &translation)
{
  double error = 0.;
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    error = std::max(error, (stokes.state.velocity[v] - translation - L * stokes.state.position[v]).norm());
  return error;
}

template <int dim>
void test()
{
  const std::string name = Utilities::int_to_string(dim) + "D ";
  ParticleCloud<dim> cloud;
  FluidMesh<dim> mesh;
  make_mesh(cloud, mesh);

  // Slightly compressible: the pressure of an enclosed incompressible fluid would have a free constant.
  const auto newtonian = make_law("Newtonian",
                                  {{"Density", "1"}, {"Bulk modulus", "10"}, {"Viscosity", "2"}});
  const auto bingham   = make_law("Bingham", {{"Density", "1"},
                                              {"Bulk modulus", "10"},
                                              {"Plastic viscosity", "1"},
                                              {"Yield stress", "3"},
                                              {"Regularization parameter", "5"}});

  Tensor<2, dim> L;
  L[0][0] = 0.7;
  L[0][1] = 1.1;
  L[1][0] = -0.4;
  for (unsigned int d = 1; d < dim; ++d)
    L[d][d] = -0.7 / (dim - 1);
  if (dim == 3)
    L[dim - 1][0] = 0.6;
  Tensor<1, dim> translation;
  translation[0] = 0.3;

  for (const std::string form : {"projected residual", "residual", "FIC interior", "FIC"})
    for (const FluidLaw *law : {newtonian.get(), bingham.get()})
    {
      Stokes<dim> stokes(mesh, cloud, *law, Tensor<1, dim>(), 1.,
                         "subsection Stabilization\n set Form = " + form + "\nend\n");
      unsigned int n_free = 0;
      for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
        if (cloud.kind[stokes.mesh.particle(v)] == ParticleKind::wall)
        {
          stokes.constraints[v].n_fixed = dim;
          stokes.state.velocity[v]      = translation + L * stokes.state.position[v];
        }
        else
          ++n_free;
      AssertThrow(Utilities::MPI::sum(n_free, MPI_COMM_WORLD) > 20, ExcInternalError());
      const bool is_newtonian = law == newtonian.get();
      if (!is_newtonian)
        stokes.solve(ViscosityLinearization::picard, 1e-3, 100);
      const unsigned int n_iterations = stokes.solve(ViscosityLinearization::newton, 1e-12, 20);
      check(name + (is_newtonian ? "Newtonian, " : "Bingham, ") + form + ": velocity of the patch test",
            velocity_error(stokes, L, translation), 1e-10);
      double pressure = 0.;
      for (const double p : stokes.state.pressure)
        pressure = std::max(pressure, std::abs(p));
      check(name + "no pressure", pressure, 1e-9);
      check(name + "converged", n_iterations <= (is_newtonian ? 3 : 8));
    }

  // Rigid motion of the unconstrained fluid.
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b <= a; ++b)
      L[b][a] = -(L[a][b] = (a == b ? 0. : 1. + a));
  Stokes<dim> stokes(mesh, cloud, *bingham, Tensor<1, dim>(), 1., "");
  for (unsigned int v = 0; v < stokes.mesh.n_vertices(); ++v)
    stokes.state.velocity[v] = translation + L * stokes.state.position[v];
  stokes.assembler.start_plastic_dual(stokes.mesh, *bingham, stokes.state);
  double stress = 0.;
  for (const SymmetricTensor<2, dim> &dual : stokes.state.plastic_dual)
    stress = std::max(stress, bingham->yield_stress(0.).value * dual.norm());
  check(name + "rigid motion makes no plastic stress", stress, 1e-10);
  stokes.assemble(ViscosityLinearization::primal_dual);
  // The nodes turn by 1e-6, which counts as strain.
  check(name + "rigid motion leaves no residual", stokes.system.right_hand_side().linfty_norm(), 2e-5);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  return n_failed;
}
