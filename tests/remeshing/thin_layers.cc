// SPDX-License-Identifier: GPL-3.0-or-later

// Test that in the plane a layer thinner than the shortest edge keeps its particles, those that have landed on the bed and
// those at its rim, step after step, and loses them only where it is thinner than 0.18 h.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/remesher.h>

#include "tests.h"

using namespace Tests;

/// A layer at rest on a floor, h = 1: particles in contact and as many of the surface, each of these @p ahead of one of
/// those; and the rim, in contact, one mesh size in front of the last ones in contact.
struct Layer
{
  static constexpr unsigned int n = 10;
  ParticleCloud<2> cloud;
  Walls<2> walls;
  FluidMesh<2> mesh;
  Migration<2> migration{MPI_COMM_SELF};
  Remesher<2> remesher;

  Layer(const double height, const double ahead)
    : walls({{{{{-20., 0.}, {20., 0.}}}, true}})
  {
    parse(remesher, "");
    for (unsigned int k = 0; k <= n; ++k)
    {
      cloud.append(Point<2>(k, contact_offset), ParticleKind::fluid, 1.);
      cloud.contact_facets.back()[0] = 0;
    }
    for (unsigned int k = 0; k < n; ++k)
      cloud.append(Point<2>(k + ahead, height), ParticleKind::fluid, 1.);
    std::vector<Simplex<2>> cells{{{n - 1, n, 2 * n}}};
    for (unsigned int k = 0; k + 1 < n; ++k)
    {
      const unsigned int surface = n + 1 + k;
      cells.push_back({{k, k + 1, surface}});
      cells.push_back({{k + 1, surface + 1, surface}});
    }
    mesh.reinit(cloud, cells);
  }

  unsigned int n_landed() const
  {
    unsigned int result = 0;
    for (const unsigned int i : mesh.particles())
      result += cloud.in_contact(i);
    return result;
  }

  /// Remesh and return how many of the particles in contact and of the surface are left.
  std::pair<unsigned int, unsigned int> remesh()
  {
    remesher.remesh(cloud, walls, {}, 1e-3, mesh, migration);
    return {n_landed(), mesh.particles().size() - n_landed()};
  }
};

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::pair<unsigned int, unsigned int> all(Layer::n + 1, Layer::n);
  for (const double height : {0.55, 0.35, 0.2})
    for (const double ahead : {0., 0.6, 0.8})
    {
      Layer layer(height, ahead);
      bool stays = true;
      for (unsigned int step = 0; step < 4; ++step)
        stays = stays && layer.remesh() == all;
      std::cout.precision(2);
      std::cout << "height " << height << ", surface " << ahead << " ahead: ";
      check("all stay", stays);
    }
  Layer dent(0.4, 0.);
  dent.cloud.position[Layer::n + 1 + Layer::n / 2][1] = 0.15;
  const auto [landed, of_surface]                     = dent.remesh();
  check("what has landed goes below 0.18 h", landed == Layer::n && of_surface == Layer::n);
  return n_failed > 0;
}
