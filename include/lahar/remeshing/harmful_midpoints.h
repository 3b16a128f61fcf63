// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_harmful_midpoints_h
#define lahar_remeshing_harmful_midpoints_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * By edge of a mesh in space whether a particle in its middle would do harm (in the plane all are taken for harmless):
   *
   * - where it would be nearer than @p smallest_distance times h to another corner of the cells around the edge, because
   *   one of the two would be removed again;
   * - where it would be less than h/2 under the free surface, and the edge does not lie on it: the tetrahedra between such
   *   a particle and the surface would be flat. Beside a wall, whose particles above the surface lie in their
   *   circumspheres, there would be none, but a dent in the fluid;
   * - where the edge passes through a wall, as that of fluid that is dragged over the edge of an obstacle does: the
   *   particle would be in the obstacle, and never leave it.
   *
   * @param edges two particles each.
   */
  template <int dim>
  std::vector<bool> harmful_midpoints(const std::vector<std::pair<unsigned int, unsigned int>> &edges,
                                      const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                      const FluidMesh<dim> &mesh, const double smallest_distance);
} // namespace Lahar

#endif
