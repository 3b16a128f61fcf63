// SPDX-License-Identifier: GPL-3.0-or-later

// Test the walls and free slip along them: distances and crossings, frames for one wall, a hollow corner, a skew wall
// and edges and corners in 3D, contact, sliding over a rim and projection.

#include <lahar/boundary/free_flight.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/remeshing/migration.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

template <int dim>
double orthonormality_error(const Tensor<2, dim> &frame)
{
  return (frame * transpose(frame) - unit_symmetric_tensor<dim>()).norm();
}

/// Check a particle's constraint: the fixed rows of the frame span the given normals.
template <int dim>
void check_frame(const std::string &name, const NodeConstraint<dim> &constraint,
                 const std::vector<Tensor<1, dim>> &normals)
{
  check(name + ": number of fixed components", constraint.n_fixed == normals.size());
  check(name + ": orthonormal frame", orthonormality_error<dim>(constraint.frame), 1e-14);
  double outside = 0.;
  for (Tensor<1, dim> normal : normals)
  {
    for (unsigned int a = 0; a < constraint.n_fixed; ++a)
      normal -= (normal * constraint.frame[a]) * constraint.frame[a];
    outside = std::max(outside, normal.norm());
  }
  check(name + ": the normals are fixed", outside, 1e-14);
}

void test_walls()
{
  const Walls<2> walls({{{{{0., 0.}, {2., 0.}}}, false}, {{{{1., 1.}, {2., 2.}}}, true}});
  const double side = walls.normal(0)[1];
  check("unit normals", std::abs(side) - 1. + walls.normal(1).norm() - 1., 1e-15);
  check("signed distance", walls.signed_distance(0, {5., 3.}) - 3. * side, 1e-15);
  check("distance from the skew wall", std::abs(walls.signed_distance(1, {2., 1.})) - std::sqrt(0.5), 1e-15);
  check("above the facet", walls.is_above(0, {0.1, 7.}, 0.));
  check("beside the facet", !walls.is_above(0, {-0.1, 7.}, 0.) && walls.is_above(0, {-0.1, 7.}, 0.2));

  using Found = std::vector<unsigned int>;
  check("near", walls.near({1.5, 0.05}, 0.1) == Found{0} && walls.near({1., 0.5}, 0.1).empty());
  check("crossed downwards", walls.crossed({1., 1e-3}, {1., -1e-3}, 0., 0.) == Found{0});
  check("crossed upwards", walls.crossed({1., -1e-3}, {1., 1e-3}, 0., 0.) == Found{0});
  check("ends before the wall", walls.crossed({0.5, 1.}, {0.5, 1e-9}, 0., 0.).empty());
  check("ends within the tolerance", walls.crossed({0.5, 1.}, {0.5, -1e-3}, 1e-2, -1e-2).empty());
  check("passes beside the rim", walls.crossed({2.01, 1.}, {2.01, -1.}, 0., 0.).empty());
  check("passes within the enlarged rim", walls.crossed({2.01, 1.}, {2.01, -1.}, 0., 0.02) == Found{0});
  check("runs along the wall", walls.crossed({0.5, 0.}, {1.5, 0.}, 1e-3, -1e-3).empty());
  check("crosses two walls", walls.crossed({1.1, 1.5}, {1.5, -0.1}, 0., 0.) == Found{0, 1});

  const Walls<3> triangle({{{{Point<3>(0., 0., 0.), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.)}}, false}});
  check("3D: crossed inside", triangle.crossed({0.3, 0.3, 1.}, {0.3, 0.3, -1.}, 0., 0.) == Found{0});
  check("3D: passes beside", triangle.crossed({0.6, 0.6, 1.}, {0.6, 0.6, -1.}, 0., 0.).empty());
  check("3D: passes within the enlarged rim",
        triangle.crossed({0.3, -1e-9, 1.}, {0.3, -1e-9, -1.}, 0., 0.).empty() &&
          triangle.crossed({0.3, -1e-9, 1.}, {0.3, -1e-9, -1.}, 0., 1e-8) == Found{0});
  check("3D: distance", std::abs(triangle.signed_distance(0, {9., 9., -2.})) - 2., 1e-15);
}

void test_2d()
{
  // A slip floor from x = 0 to 2, a slip wall at x = 0, a skew slip wall from (2, 0) to (3, 1).
  const Walls<2> walls(
    {{{{{0., 0.}, {2., 0.}}}, true}, {{{{0., 0.}, {0., 2.}}}, true}, {{{{3., 1.}, {4., 2.}}}, true}});
  const WallStep<2> standing(walls);
  const WallContact<2> slip(standing);
  const double h = 0.1, off = contact_offset * h; // on its side of the facet
  ParticleCloud<2> cloud;
  const auto add           = [&](const Point<2> &p) { return cloud.append(p, ParticleKind::fluid, h); };
  const unsigned int floor = add({1., 0.}), corner = add({off, off}), skew = add({3.5, 1.5}),
                     inner = add({1., 0.5}), wall = cloud.append({1.5, 0.}, ParticleKind::wall, h);
  slip.initialize(cloud);
  const Tensor<1, 2> e_x = Point<2>(1., 0.), e_y = Point<2>(0., 1.),
                     diagonal = Point<2>(-1., 1.) / std::sqrt(2.);
  check_frame<2>("floor", slip.constraint(floor, cloud), {e_y});
  check_frame<2>("hollow corner", slip.constraint(corner, cloud), {e_x, e_y});
  check_frame<2>("skew wall", slip.constraint(skew, cloud), {diagonal});
  check_frame<2>("inner particle", slip.constraint(inner, cloud), {});
  check("wall particle is fixed", slip.constraint(wall, cloud).n_fixed == 2 && !cloud.in_contact(wall));

  // Through the floor; near the floor; near the skew wall; along the floor over its rim; into the corner.
  const unsigned int through = add({0.5, 0.02}), close = add({0.7, 0.05}), to_skew = add({3.5, 1.7}),
                     over = add({1.99, 0.}), into = add({0.3, off}), away = add({1.2, 0.05});
  cloud.contact_facets[over][0] = cloud.contact_facets[into][0] = 0;
  std::vector<Point<2>> old_position                            = cloud.position;
  cloud.position[through]                                       = {0.52, -0.03};
  cloud.velocity[through]                                       = Point<2>(2., -5.);
  cloud.acceleration[through]                                   = Point<2>(1., -9.);
  cloud.position[close]                                         = {0.72, 0.009};
  cloud.velocity[close]                                         = Point<2>(2., -4.);
  cloud.position[to_skew]                                       = Point<2>(3.5, 1.5) - 0.004 * diagonal;
  cloud.velocity[to_skew]                                       = Point<2>(3., 1.);
  cloud.position[over]                                          = {2.01, 0.};
  cloud.velocity[over]                                          = Point<2>(2., 0.);
  cloud.position[into]                                          = {-0.02, off};
  cloud.velocity[into]                                          = Point<2>(-3., 0.);
  cloud.position[away]                                          = {1.2, 0.011};
  slip.update(old_position, cloud);
  check("through the floor: put on it", (cloud.position[through] - Point<2>(0.52, off)).norm(), 1e-15);
  check("and slides",
        (cloud.velocity[through] - Point<2>(2., 0.)).norm() +
          (cloud.acceleration[through] - Point<2>(1., 0.)).norm(),
        1e-15);
  check_frame<2>("through the floor", slip.constraint(through, cloud), {e_y});
  check("near the floor: put on it", (cloud.position[close] - Point<2>(0.72, off)).norm(), 1e-15);
  check("skew wall: put on it", (cloud.position[to_skew] - Point<2>(3.5, 1.5)).norm() - off, 1e-14);
  check("keeps its tangential velocity", (cloud.velocity[to_skew] - Point<2>(2., 2.)).norm(), 1e-14);
  check("over the rim: free", !cloud.in_contact(over));
  check("into the corner: put there", (cloud.position[into] - Point<2>(off, off)).norm(), 1e-15);
  check("and stopped", cloud.velocity[into].norm(), 1e-15);
  check_frame<2>("into the corner", slip.constraint(into, cloud), {e_x, e_y});
  check("above the distance of contact: free", !cloud.in_contact(away));
  check("no contact moves the others", (cloud.position[inner] - Point<2>(1., 0.5)).norm() == 0. &&
                                         cloud.in_contact(floor) && cloud.in_contact(corner));
}

void test_3d()
{
  // The floor z = 0 and the walls x = 0 and y = 0 of a box, two triangles each.
  std::vector<WallFacet<3>> facets;
  for (unsigned int d = 0; d < 3; ++d)
  {
    Point<3> a, b, c;
    a[d]           = 0.;
    b[(d + 1) % 3] = c[(d + 2) % 3] = 1.;
    const Point<3> far              = b + Tensor<1, 3>(c);
    facets.push_back({{{a, b, far}}, true});
    facets.push_back({{{a, far, c}}, true});
  }
  const Walls<3> walls(facets);
  const WallStep<3> standing(walls);
  const WallContact<3> slip(standing);
  ParticleCloud<3> cloud;
  for (const Point<3> &p :
       {Point<3>(0.3, 0.4, 0.), Point<3>(0.3, 0., 0.), Point<3>(0., 0., 0.), Point<3>(0.5, 0.5, 0.)})
    cloud.append(p, ParticleKind::fluid, 0.1);
  slip.initialize(cloud);
  const Tensor<1, 3> e_x = Point<3>(1., 0., 0.), e_y = Point<3>(0., 1., 0.), e_z = Point<3>(0., 0., 1.);
  check_frame<3>("3D floor", slip.constraint(0, cloud), {e_z});
  check_frame<3>("3D edge", slip.constraint(1, cloud), {e_y, e_z});
  check_frame<3>("3D corner", slip.constraint(2, cloud), {e_x, e_y, e_z});
  check_frame<3>("3D seam of two triangles in a plane", slip.constraint(3, cloud), {e_z});

  const double off                   = contact_offset * 0.1;
  std::vector<Point<3>> old_position = cloud.position;
  cloud.position[0]                  = {0.3, -0.02, 0.};
  cloud.velocity[0]                  = Point<3>(1., -2., 0.);
  slip.update(old_position, cloud);
  check("3D: slides from the floor into the edge", (cloud.position[0] - Point<3>(0.3, off, off)).norm(),
        1e-15);
  check("3D: and on along it", (cloud.velocity[0] - Point<3>(1., 0., 0.)).norm(), 1e-15);
  check_frame<3>("3D edge", slip.constraint(0, cloud), {e_y, e_z});

  // A particle in the corner stays there whatever facets it meets again.
  old_position      = cloud.position;
  cloud.position[2] = {-1e-3, -2e-3, -3e-3};
  slip.update(old_position, cloud);
  check("3D: stays in the corner",
        slip.constraint(2, cloud).n_fixed == 3 || cloud.position[2].norm() < 1e-14);
}

/// Isolated particles fly on a parabola and stop in front of no-slip walls.
void test_free_flight()
{
  const Walls<2> walls({{{{{0., 0.}, {2., 0.}}}, false}});
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  // The last two fall at the rim of the floor, by rounding beside it, and far beside it.
  for (const Point<2> &p :
       {Point<2>(1., 1.), Point<2>(1., 0.01), Point<2>(2. + 1e-12, 0.01), Point<2>(2.1, 0.01)})
    cloud.append(p, ParticleKind::fluid, 0.1);
  cloud.velocity[0] = Point<2>(1., 2.);
  cloud.velocity[1] = Point<2>(0., -3.);
  cloud.pressure[0] = 5.;
  for (unsigned int step = 0; step < 10; ++step)
  {
    const std::vector<Point<2>> old_position = cloud.position;
    move_isolated_particles(mesh, Point<2>(0., -10.), 0.01, cloud);
    stop_at_walls(old_position, WallStep<2>(walls), cloud);
  }
  check("free flight: parabola", (cloud.position[0] - Point<2>(1.1, 1. + 0.2 - 0.05)).norm(), 1e-14);
  check("free flight: velocity", (cloud.velocity[0] - Point<2>(1., 1.)).norm(), 1e-14);
  check("free flight: no pressure", cloud.pressure[0], 0.);
  check("stops in front of the wall", cloud.position[1][1] > 0. && cloud.position[1][1] <= 0.011);
  check("stops in front of its rim", cloud.position[2][1] > 0. && cloud.position[2][1] <= 0.011);
  check("falls beside it", cloud.position[3][1] < 0.);
}

/// Particles that slide from rank to rank along a floor and into a corner: each rank finds what one rank does.
void test_ranks()
{
  const Walls<2> walls({{{{{0., 0.}, {4., 0.}}}, true}, {{{{4., 0.}, {4., 2.}}}, true}});
  const WallStep<2> standing(walls);
  const WallContact<2> slip(standing);
  constexpr double h = 0.1;
  ParticleCloud<2> whole;
  for (unsigned int j = 0; j < 5; ++j)
    for (unsigned int i = 0; i < 30; ++i)
      whole.append({h * i, h * j}, ParticleKind::fluid, h);
  slip.initialize(whole);
  ParticleCloud<2> part = whole;
  Migration<2> migration(MPI_COMM_WORLD);
  migration.distribute(part, 3. * h, 0);
  FluidMesh<2> no_mesh;

  const auto step = [&](ParticleCloud<2> &cloud) {
    const std::vector<Point<2>> old_position = cloud.position;
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      cloud.velocity[i] = Point<2>(1.5, -0.3 * old_position[i][1] - 0.1);
      cloud.position[i] += 0.05 * cloud.velocity[i];
    }
    slip.update(old_position, cloud);
  };
  bool same = true;
  std::vector<unsigned int> n_in_contact;
  for (unsigned int k = 0; k < 20; ++k)
  {
    step(whole);
    step(part);
    migration.migrate(part, no_mesh, 3. * h, 0);
    for (unsigned int i = 0; i < part.size(); ++i)
    {
      const unsigned int j               = part.number[i];
      const NodeConstraint<2> constraint = slip.constraint(i, part), expected = slip.constraint(j, whole);
      same = same && part.position[i] == whole.position[j] && part.velocity[i] == whole.velocity[j] &&
             part.contact_facets[i] == whole.contact_facets[j] && constraint.n_fixed == expected.n_fixed &&
             constraint.frame == expected.frame;
    }
    n_in_contact.push_back(0);
    for (unsigned int i = 0; i < part.size(); ++i)
      n_in_contact.back() += part.is_own(i) && part.in_contact(i);
  }
  check("ranks: positions, velocities and constraints of one", same);
  Utilities::MPI::sum(n_in_contact, MPI_COMM_WORLD, n_in_contact);
  check("ranks: ever more in contact", n_in_contact.front() == 30 && n_in_contact.back() > 60);
  if (const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); n_ranks > 1)
    same = part.size() < whole.size();
  check("ranks: each has some", same);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_walls();
  test_2d();
  test_3d();
  test_free_flight();
  test_ranks();
  return n_failed > 0;
}
