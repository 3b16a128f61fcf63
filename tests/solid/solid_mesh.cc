// SPDX-License-Identifier: GPL-3.0-or-later

// Test the solids' mesh: volume and mass, contour, deformation gradients; the derivative of the assembled residual; and
// particles that must stay outside.

#include <lahar/assembly/solid_assembler.h>
#include <lahar/boundary/solid_contour.h>
#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/linear/direct_solver.h>

#include "tests.h"


using namespace Tests;

template <int dim>
void make(Solids<dim> &solids, const unsigned int degree, const std::string &law)
{
  const std::string box  = dim == 2 ? "0.1, 0 : 0.3, 0.5" : "0.1, 0, 0 : 0.3, 0.5, 0.2",
                    foot = dim == 2 ? "0.1, 0 : 0.3, 0" : "0.1, 0, 0 : 0.3, 0, 0.2",
                    load = dim == 2 ? "0.1, 0.5 : 0.3, 0.5" : "0.1, 0.5, 0 : 0.3, 0.5, 0.2";
  Parameters prm;
  Solids<dim>::declare_parameters(prm, {"beam"});
  prm.parse_input_from_string(
    "subsection Solids\n set Degree = " + std::to_string(degree) +
    "\n subsection beam\n set Shape = box\n subsection box\n set Corners = " + box +
    "\n set Elements = " + (dim == 2 ? "2, 3" : "2, 3, 1") + "\n end\n set Clamped = " + foot +
    "\n set Loaded = " + load + "\n set Traction = " + (dim == 2 ? "t; 3*t" : "t; 3*t; 0") +
    "\n set Law = " + law + "\n subsection " + law + "\n set Poisson's ratio = 0.3\n end\n end\nend\n");
  solids.parse_parameters(prm, {"beam"});
  check("no warning", solids.create(0.1, 0., true).empty());
}

template <int dim>
void test_mesh(const unsigned int degree)
{
  const std::string name = std::to_string(dim) + "D, degree " + std::to_string(degree) + ": ";
  Solids<dim> solids;
  make(solids, degree, "hypoelastic");
  const SolidMesh<dim> &mesh = solids.mesh();
  const double exact         = dim == 2 ? 0.1 : 0.02;

  double volume = 0., mass = 0.;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
  {
    for (unsigned int q = 0; q < mesh.points_per_cell(); ++q)
      volume += mesh.volume(c, q);
    for (unsigned int I = 0; I < mesh.nodes_per_cell(); ++I)
      for (unsigned int J = 0; J < mesh.nodes_per_cell(); ++J)
        mass += mesh.mass(c, I, J);
  }
  check(name + "volume", volume - exact, 1e-14);
  check(name + "mass per density", mass - exact, 1e-14);

  // The divergence theorem over the contour: ∫ x·n = dim V; all normals point out.
  ParticleCloud<dim> cloud;
  solids.append_particles(0.1, std::vector<bool>(solids.all_bodies().size(), false), cloud);
  const SolidContour<dim> contour(mesh.contour(), cloud);
  double flux            = 0.;
  bool all_are_particles = true;
  for (const auto &facet : contour.wall_facets())
  {
    Tensor<1, dim> normal;
    if constexpr (dim == 2)
      normal = cross_product_2d(facet.corners[1] - facet.corners[0]);
    else
      normal = 0.5 *
               cross_product_3d(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]);
    flux += normal * facet.corners[0];
  }
  for (const auto &facet : mesh.contour())
    for (const unsigned int node : facet)
      all_are_particles = all_are_particles && node < mesh.n_contour_nodes() && node < cloud.size();
  check(name + "contour is closed and looks outwards", flux - dim * exact, 1e-14);
  check(name + "the contour's nodes come first", all_are_particles && cloud.size() == mesh.n_contour_nodes());
  Point<dim> inside, outside;
  for (unsigned int d = 0; d < dim; ++d)
  {
    inside[d]  = 0.15 - 0.01 * d;
    outside[d] = d == 0 ? 0.05 : 0.1;
  }
  check(name + "inside and outside", contour.is_inside(inside) && !contour.is_inside(outside));

  // x = A X gives F = A at every point.
  Random random;
  Tensor<2, dim> A = unit_symmetric_tensor<dim>();
  for (unsigned int i = 0; i < dim; ++i)
    A[i] += 0.3 * random.template vector<dim>();
  std::vector<Point<dim>> positions;
  for (unsigned int i = 0; i < mesh.n_nodes(); ++i)
    positions.push_back(Point<dim>(A * mesh.reference_position(i)));
  double error = 0.;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    for (unsigned int q = 0; q < mesh.points_per_cell(); ++q)
    {
      const Tensor<2, 3> F = mesh.deformation_gradient(c, q, positions);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          error = std::max(error, std::abs(F[i][j] - (i < dim && j < dim ? A[i][j] : (i == j ? 1. : 0.))));
    }
  check(name + "deformation gradient of a linear map", error, 1e-12);

  // The loads add up to traction times area.
  Tensor<1, dim> force;
  for (const Tensor<1, dim> &f : solids.external_forces(2.))
    force += f;
  check(name + "load",
        std::abs(force[0] - (dim == 2 ? 0.4 : 0.08)) + std::abs(force[1] - (dim == 2 ? 1.2 : 0.24)), 1e-13);
}

template <int dim>
void test_tangent(const unsigned int degree, const std::string &law)
{
  const std::string name = law + ", " + std::to_string(dim) + "D, degree " + std::to_string(degree) + ": ";
  Solids<dim> solids;
  make(solids, degree, law);
  const SolidMesh<dim> &mesh = solids.mesh();
  Random random;
  SolidState<dim> old = solids.state();
  for (Point<dim> &x : old.position)
    x += 0.005 * random.template vector<dim>();
  for (auto &stress : old.stress)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        stress[i][j] = 1e5 * random.number();
  solids.accept(old);

  const SolidFactors factors{0.01, 70.};
  const SolidAssembler<dim> assembler;
  IndexVector<SolidNode, RegionNode> nodes;
  for (unsigned int i = 0; i < mesh.n_nodes(); ++i)
    nodes.push_back(RegionNode(i));
  Tensor<1, dim> gravity;
  gravity[1] = -9.81;
  std::vector<Tensor<1, dim>> direction;
  for (unsigned int i = 0; i < mesh.n_nodes(); ++i)
    direction.push_back(random.template vector<dim>());
  const auto moved = [&](const double length) {
    SolidState<dim> state = old;
    for (unsigned int i = 0; i < mesh.n_nodes(); ++i)
    {
      const Tensor<1, dim> velocity = std::sin(1. + i) * direction[i] + length * direction[i];
      state.position[i] += factors.position * velocity;
      state.acceleration[i] = factors.acceleration * velocity;
    }
    return state;
  };

  BlockSystem<dim> system(MPI_COMM_WORLD);
  system.reinit(0, {}, {mesh.n_nodes(), mesh.cell_nodes(), mesh.nodes_per_cell()},
                IndexVector<RegionNode, Point<dim>>(old.position));
  const auto residual = [&](const double length) {
    system.set_zero();
    const auto forces = solids.external_forces(1.);
    check(name + "assembled",
          assembler.assemble(solids, moved(length), factors, {gravity, forces}, nodes, system));
    return system.right_hand_side();
  };
  const double step = 1e-5;
  auto plus = residual(step), minus = residual(-step), product = residual(0.), increment = product;
  const NodePartition &partition = system.partition();
  for (const LocalNode l : partition.own_nodes())
    for (unsigned int d = 0; d < dim; ++d)
      increment.block(0)[partition.nodes()[l].value() * dim + d] = direction[partition.nodes()[l].value()][d];
  increment.compress(VectorOperation::insert);
  system.matrix().block(0, 0).vmult(product.block(0), increment.block(0));
  minus.sadd(0.5 / step, -0.5 / step, plus); // − dR/dv
  minus -= product;
  check(name + "tangent against differences", minus.block(0).l2_norm() / product.block(0).l2_norm(), 1e-7);

  // With the foot clamped the system can be solved, without any fluid.
  IndexVector<LocalNode, NodeConstraint<dim>> constraints(partition.nodes().size());
  for (const LocalNode l : constraints.indices())
    constraints[l].n_fixed = solids.is_fixed(partition.nodes()[l].value()) ? dim : 0;
  system.set_constraints(constraints);
  auto right_hand_side = residual(0.);
  auto solution        = system.make_vector();
  DirectSolver<dim> solver;
  parse(solver);
  solver.solve(system, {}, solution);
  system.matrix().block(0, 0).vmult(product.block(0), solution.block(0));
  product.block(0) -= right_hand_side.block(0);
  check(name + "solution", product.block(0).l2_norm() / right_hand_side.block(0).l2_norm(), 1e-10);
  double fixed          = 0.;
  const auto velocities = system.velocities(solution);
  for (const LocalNode l : velocities.indices())
    if (solids.is_fixed(partition.nodes()[l].value()))
      fixed += velocities[l].norm();
  check(name + "clamped nodes stay", fixed, 1e-14);
}

void test_keep_out()
{
  Solids<2> solids;
  make(solids, 1, "hypoelastic");
  ParticleCloud<2> cloud;
  solids.append_particles(0.05, std::vector<bool>(solids.all_bodies().size(), false), cloud);
  const unsigned int first = cloud.size();
  // One before the solid that moves away from it, one that the solid runs over, one that flies through the whole solid.
  cloud.append({0.05, 0.2}, ParticleKind::fluid, 0.05);
  cloud.append({0.09, 0.25}, ParticleKind::fluid, 0.05);
  cloud.append({0.05, 0.3}, ParticleKind::fluid, 0.05);
  std::vector<Point<2>> old_position = cloud.position;
  for (unsigned int i = 0; i < first; ++i)
  {
    cloud.position[i][0] -= 0.03;
    cloud.velocity[i][0] = -30.;
  }
  cloud.position[first + 2][0] = 0.6;
  const unsigned int n = SolidContour<2>(solids.mesh().contour(), cloud).keep_out(old_position, cloud);
  check("two particles are kept out", n == 2 && cloud.position[first] == old_position[first]);
  check("they stand before the solid",
        std::abs(cloud.position[first + 1][0] - 0.065) + std::abs(cloud.position[first + 2][0] - 0.065),
        1e-12);
  check("and move with it",
        std::abs(cloud.velocity[first + 1][0] + 30.) + std::abs(cloud.velocity[first + 2][0] + 30.), 1e-12);
}

void test_constrained_delaunay()
{
  // A point close to the middle of a long segment: its edge is in no Delaunay triangulation.
  const std::vector<Point<2>> points{{0., 0.}, {1., 0.}, {0.5, 0.1}, {0.5, -0.1}};
  const std::vector<std::array<unsigned int, 2>> segment = {{{0, 1}}}, edge = {{{0, 2}}},
                                                 crossing = {{{0, 1}}, {{2, 3}}};
  ConstrainedDelaunay triangulation(points, segment);
  triangulation.insert({0, 1, 2, 3});
  const auto cells = triangulation.simplices();
  bool crosses     = false;
  double area      = 0.;
  for (const Simplex<2> &cell : cells)
  {
    crosses = crosses ||
              (std::count(cell.begin(), cell.end(), 2U) + std::count(cell.begin(), cell.end(), 3U) == 2);
    area += signed_volume<2>(corners_of<2>(cell, points));
  }
  check("the segment is an edge", !crosses && triangulation.forced()[0] && cells.size() == 2);
  check("the triangles fill the hull", area - 0.1, 1e-15);
  ConstrainedDelaunay natural(points, edge);
  natural.insert({0, 1, 2, 3});
  check("an edge that is there is not counted", !natural.forced()[0]);
  check_throws<RunError>("segments that cross", {"contours of two solids cross"}, [&] {
    ConstrainedDelaunay(points, crossing).insert({0, 1, 2, 3});
  });
}

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
  {
    test_mesh<2>(degree);
    test_mesh<3>(degree);
    for (const std::string law : {"hypoelastic", "neo-Hookean"})
    {
      test_tangent<2>(degree, law);
      test_tangent<3>(degree, law);
    }
  }
  test_keep_out();
  test_constrained_delaunay();
  return n_failed;
}
