// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_wall_faces_h
#define lahar_remeshing_wall_faces_h

#include <lahar/geometry/walls.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * The free surface without faces that lie on a wall of several facets: their corners are all in contact, on different
   * facets, of one plane or of a surface that goes on smoothly from each to the next (smooth_joint) behind the face.
   * FluidMesh, which knows no walls, takes them for free surface; a wall is to be as one of a single facet, however it is
   * divided.
   */
  template <int dim>
  std::vector<BoundaryFace> free_surface_faces(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                               const Walls<dim> &walls);

  /// Whether two particles are in contact with the same facets, or with facets that go on smoothly into each other, on the
  /// same side.
  template <int dim>
  bool are_on_one_surface(const unsigned int a, const unsigned int b, const ParticleCloud<dim> &cloud,
                          const Walls<dim> &walls);

  /// Put @p particle, in the middle between two @p parents that are in contact with different facets of a plane wall, in
  /// contact with that of these which it lies on.
  template <int dim>
  void touch_plane_wall(const unsigned int particle, const std::pair<unsigned int, unsigned int> &parents,
                        const Walls<dim> &walls, ParticleCloud<dim> &cloud);
} // namespace Lahar

#endif
