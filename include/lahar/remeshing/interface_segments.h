// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_interface_segments_h
#define lahar_remeshing_interface_segments_h

#include <lahar/remeshing/interface_faces.h>
#include <lahar/remeshing/old_domain.h>

#include <array>
#include <vector>

namespace Lahar
{
  /**
   * The interfaces of the last mesh as edges between the present particles, for a constrained triangulation: @p faces of
   * the last mesh where both ends are still there, the halves of those that were divided, and over a removed particle
   * with two of them the way between their other ends. None is longer than 2 h or @p reach (m), and none crosses another
   * one or one of the segments @p taken: such interfaces have been torn.
   */
  std::vector<std::array<unsigned int, 2>>
  find_interface_segments(const std::vector<InterfaceFace<2>> &faces, const OldDomain<2> &old_domain,
                          const ParticleCloud<2> &cloud, const double reach,
                          const std::vector<std::array<unsigned int, 2>> &taken);
} // namespace Lahar

#endif
