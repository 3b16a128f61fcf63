// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_automatic_augmentation_h
#define lahar_simulator_automatic_augmentation_h

#include <lahar/material/fluid_law.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <vector>

namespace Lahar
{
  /**
   * Let each law that asks for it choose its r for a step from the inertia ρ L²/Δt of its fluid, see
   * YieldStressLaw::choose_augmentation(). L = 2 V/A is the depth of a layer and half that of a block, V the volume of the
   * fluid's cells and A the area of their faces where the mesh ends, in the half plane (r, z) those of the section.
   *
   * @param time_step is its length, s. @param laws by the fluids' numbers. Collective.
   */
  template <int dim>
  void choose_augmentations(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                            const double time_step, const MPI_Comm &communicator,
                            const std::vector<FluidLaw *> &laws);
} // namespace Lahar

#endif
