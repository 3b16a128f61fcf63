// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_wall_segments_h
#define lahar_remeshing_wall_segments_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>

#include <array>
#include <vector>

namespace Lahar
{
  /**
   * Pairs of particles that lie next to each other on the same side of a facet behind which there is fluid, too, nearer
   * than its spacing. As edges of a constrained triangulation they keep the particles of one side from shaping the
   * triangles of the other one. None is longer than @p reach (m), and none passes through a wall.
   */
  std::vector<std::array<unsigned int, 2>> find_wall_segments(const ParticleCloud<2> &cloud,
                                                              const Walls<2> &walls, const double reach);
} // namespace Lahar

#endif
