// SPDX-License-Identifier: GPL-3.0-or-later

// Test which simplices outside the old domain lie in a hollow between walls: an edge where a floor and a wall meet, whose
// four wall particles have a simplex of their own without a fluid corner.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/old_domain.h>

#include "tests.h"

using namespace Tests;

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // The floor is z = 0, the wall x = 0; a and b lie on their edge, c on the floor, d on the wall, f in the fluid; e is a
  // dry particle of the wall.
  ParticleCloud<3> cloud;
  const unsigned int a = cloud.append(Point<3>(0., 0., 0.), ParticleKind::wall, 1.),
                     b = cloud.append(Point<3>(0., 1., 0.), ParticleKind::wall, 1.),
                     c = cloud.append(Point<3>(1., 0.5, 0.), ParticleKind::wall, 1.),
                     d = cloud.append(Point<3>(0., 0.5, 1.), ParticleKind::wall, 1.),
                     e = cloud.append(Point<3>(0., 1.5, 1.), ParticleKind::wall, 1.),
                     f = cloud.append(Point<3>(0.9, 0.5, 0.9), ParticleKind::fluid, 1.),
                     g = cloud.append(Point<3>(0.5, 1.4, 0.7), ParticleKind::fluid, 1.);
  const auto oriented  = [&](Simplex<3> simplex) {
    if (signed_volume<3>(corners_of<3>(simplex, cloud.position)) < 0.)
      std::swap(simplex[2], simplex[3]);
    return canonical<3>(simplex);
  };
  FluidMesh<3> mesh;
  mesh.reinit(cloud, {oriented({{a, c, d, f}}), oriented({{b, c, d, f}}), oriented({{b, d, f, g}})});
  const OldDomain<3> old_domain(cloud, mesh);
  const auto lies_in_hollow = [&](const Simplex<3> &simplex) {
    const Simplex<3> cell = oriented(simplex);
    const Point<3> middle = centroid<3>(corners_of<3>(cell, cloud.position));
    return !old_domain.contains(cell, middle) && old_domain.leads_into_hollow(cell, middle, cloud);
  };
  check("fluid over the edge of walls meets the hollow", lies_in_hollow({{a, b, c, f}}));
  check("so it does from the other side", lies_in_hollow({{a, b, d, f}}));
  check("what was fluid is none", !lies_in_hollow({{a, c, d, f}}));
  check("nor is what lies before the free surface", !lies_in_hollow({{b, c, f, g}}));
  check("nor what has a dry corner", !lies_in_hollow({{b, d, e, g}}));
  return n_failed > 0;
}
