// SPDX-License-Identifier: GPL-3.0-or-later

// Test which cells a step leaves out, and that the assembly of a mesh with such a cell, even an inverted one, is that of
// the mesh without it but for a positive diagonal; in 2D and 3D, for fluid with a yield stress.

#include <deal.II/base/utilities.h>

#include <lahar/assembly/fluid_assembler.h>
#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/simulator/crushed_cells.h>

#include "tests.h"

using namespace Tests;

void test_rule()
{
  CrushedCells crushed;
  std::vector<bool> left_out(4, false);
  const auto iterate = [&](const std::vector<unsigned int> &cells) {
    crushed.note(cells);
    crushed.update(left_out);
    return left_out;
  };
  crushed.start_step(4);
  bool any = false;
  for (unsigned int i = 0; i < 4; ++i)
    any = any || iterate({1, 2}) != std::vector<bool>(4, false);
  check("four times are not enough", !any);
  check("an iteration without changes nothing", iterate({}) == std::vector<bool>(4, false));
  check("five times are", iterate({0, 2}) == std::vector<bool>({false, false, true, false}));
  check("for the rest of the step", iterate({1}) == std::vector<bool>({false, true, true, false}));
  crushed.start_step(4);
  left_out.assign(4, false);
  check("a new step begins anew", iterate({0, 1, 2, 3}) == std::vector<bool>(4, false));
}

template <int dim>
struct Problem
{
  ParticleCloud<dim> cloud;
  FluidMesh<dim> mesh;
  FluidState<dim> state;
  BlockSystem<dim> system;
  FluidAssembler<dim> assembler;

  Problem(const ParticleCloud<dim> &new_cloud, const std::vector<Simplex<dim>> &cells, const FluidLaw &law)
    : cloud(new_cloud)
    , system(MPI_COMM_WORLD)
  {
    mesh.reinit(cloud, cells);
    parse(assembler, "subsection Stabilization\n set Form = residual\nend\n");
    state.gravity[dim - 1] = -9.81;
    const unsigned int n   = mesh.n_vertices();
    state.time_step        = 1e-3;
    state.velocity_factor.assign(n, 1.5);
    state.acceleration_factor.assign(n, 2. / state.time_step);
    for (unsigned int v = 0; v < n; ++v)
    {
      const Point<dim> &x = cloud.position[mesh.particle(v)];
      state.position.push_back(x);
      state.velocity.push_back(x[0] * x[dim - 1] * (x + state.gravity));
      state.pressure.push_back(-1e3 * x[0]);
    }
    state.old_position = state.position;
    state.old_velocity = state.acceleration = state.old_acceleration = std::vector<Tensor<1, dim>>(n);
    state.old_pressure = state.old_pressure_rate = state.pressure;
    system.reinit(n, mesh.cells());
    assembler.set_stabilization(mesh, law, state);
    assembler.start_plastic_dual(mesh, law, state);
  }

  bool assemble(const FluidLaw &law)
  {
    return assembler.assemble(mesh, law, state, {}, system);
  }
};

template <int dim>
void test_assembly()
{
  const std::string name = Utilities::int_to_string(dim) + "D ";
  Random random;
  ParticleCloud<dim> cloud;
  for (unsigned int i = 0; i < 30 * dim; ++i)
    cloud.append(Point<dim>(random.vector<dim>()), ParticleKind::fluid, 0.3);
  std::vector<Simplex<dim>> cells;
  for (const Simplex<dim> &simplex : delaunay(cloud.position))
    if (signed_volume<dim>(corners_of<dim>(simplex, cloud.position)) > 1e-4)
      cells.push_back(simplex);
  const auto law = make_law("Bingham", {{"Density", "1000"},
                                        {"Plastic viscosity", "0.001"},
                                        {"Yield stress", "100"},
                                        {"Regularization parameter", "1000"}});

  // The new particle's only cell is left out.
  Simplex<dim> last = cells.back();
  last[0] = cloud.append(cloud.position[last[0]] + 0.1 * random.vector<dim>(), ParticleKind::fluid, 0.3);
  if (signed_volume<dim>(corners_of<dim>(last, cloud.position)) < 0.)
    std::swap(last[0], last[1]);
  std::vector<Simplex<dim>> more = cells;
  more.push_back(last);
  Problem<dim> with(cloud, more, *law), without(cloud, cells, *law);
  const unsigned int left_out = std::find(with.mesh.particle_cells().begin(),
                                          with.mesh.particle_cells().end(), canonical<dim>(last)) -
                                with.mesh.particle_cells().begin();
  // Turned inside out.
  const Simplex<dim> &corners = with.mesh.cells()[left_out];
  const unsigned int tip      = with.mesh.n_vertices() - 1;
  Tensor<1, dim> middle;
  for (const unsigned int v : corners)
    if (v != tip)
      middle += with.state.position[v] / dim;
  with.state.position[tip] += 2. * (middle - with.state.position[tip]);
  check(name + "an inverted cell cannot be assembled", !with.assemble(*law));
  with.state.left_out[left_out] = true;
  check(name + "one that is left out can", with.assemble(*law) && without.assemble(*law));

  double matrix_error = 0., residual_error = 0., smallest = 1e10, scale = 0.;
  const unsigned int n = without.mesh.n_vertices();
  for (unsigned int row = 0; row < 2; ++row)
    for (const auto i : with.system.right_hand_side().block(row).locally_owned_elements())
    {
      const bool is_tip   = i >= (row == 0 ? dim * n : n);
      const double before = is_tip ? 0. : without.system.right_hand_side().block(row)(i);
      residual_error      = std::max(residual_error,
                                     std::abs(with.system.right_hand_side().block(row)(i) - before));
      smallest            = std::min(smallest, with.system.matrix().block(row, row).el(i, i));
      for (unsigned int column = 0; column < 2; ++column)
        for (auto entry = with.system.matrix().block(row, column).begin(i);
             entry != with.system.matrix().block(row, column).end(i); ++entry)
        {
          const bool is_new = is_tip || entry->column() >= (column == 0 ? dim * n : n);
          const double old  = is_new ? 0. : without.system.matrix().block(row, column).el(i, entry->column());
          scale             = std::max(scale, std::abs(old));
          if (row != column || entry->column() != i)
            matrix_error = std::max(matrix_error, std::abs(entry->value() - old));
        }
    }
  check(name + "right-hand side of the mesh without it", residual_error, 1e-10);
  check(name + "matrix but for the diagonal", matrix_error, 1e-12 * scale);
  check(name + "the diagonal is positive", smallest > 0.);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_rule();
  test_assembly<2>();
  test_assembly<3>();
  return n_failed > 0;
}
