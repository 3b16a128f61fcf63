// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_drop_particles_h
#define lahar_remeshing_drop_particles_h

#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <vector>

namespace Lahar
{
  /// Remove the particles that are @p dropped, and the cells that they are corners of. @return how many of them are this
  /// rank's own.
  template <int dim>
  unsigned int drop_particles(const std::vector<bool> &dropped, ParticleCloud<dim> &cloud,
                              FluidMesh<dim> &mesh);
} // namespace Lahar

#endif
