// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_open_floor_h
#define lahar_boundary_open_floor_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>

#include <string>

namespace Lahar
{
  /**
   * A warning for the user if there are walls or solids, but none lies in the direction of gravity from some of the
   * fluid particles: the walls have a hole under the fluid, end before it, or the fluid is not where it should be.
   *
   * @param cloud of each rank its own part of the particles, in the order of ranks.
   * @param obstacles rigid walls and the solids' contours.
   * @return the text, on all ranks the same; empty if nothing is to be said. Collective.
   */
  template <int dim>
  std::string warn_of_open_floor(const ParticleCloud<dim> &cloud, const Walls<dim> &obstacles,
                                 const Tensor<1, dim> &gravity, const MPI_Comm &communicator);
} // namespace Lahar

#endif
