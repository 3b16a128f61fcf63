// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_two_layers_h
#define lahar_tests_two_layers_h

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <vector>

namespace Tests
{
  using namespace Lahar;

  /// Mesh all particles of the unit square. @param two whether cells above y = 0.5 are of a second fluid.
  inline void mesh_layers(const ParticleCloud<2> &cloud, const bool two, FluidMesh<2> &mesh)
  {
    std::vector<Simplex<2>> cells;
    std::vector<unsigned int> fluids;
    for (const Simplex<2> &cell : delaunay<2>(cloud.position))
      if (const auto corners = corners_of<2>(cell, cloud.position); signed_volume<2>(corners) > 1e-6)
      {
        cells.push_back(cell);
        fluids.push_back(two && centroid<2>(corners)[1] > 0.5);
      }
    mesh.reinit(cloud, cells, fluids);
  }
} // namespace Tests

#endif
