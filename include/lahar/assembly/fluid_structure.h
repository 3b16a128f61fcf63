// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_fluid_structure_h
#define lahar_assembly_fluid_structure_h

#include <lahar/material/materials.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>

#include <vector>

namespace Lahar
{
  /**
   * The structure parameter λ of thixotropic fluids (Thixotropy) from step to step.
   *
   * Each particle has a λ of every thixotropic fluid that it belongs to or has a cell of (ParticleCloud::structure):
   * particles on an interface may have several, those of walls and solids that of the fluid that sticks to them. A cell
   * has the mean over its corners. All functions do nothing without a thixotropic fluid.
   */
  template <int dim>
  struct FluidStructure
  {
    /// Let the cloud have a λ for each fluid, before there are any particles with one.
    static void prepare(const Materials &materials, ParticleCloud<dim> &cloud);

    /// Let particles that are not older than @p first_number have the λ of new fluid.
    static void refresh(const std::uint64_t first_number, const Materials &materials,
                        ParticleCloud<dim> &cloud);

    /**
     * After remeshing: a particle that has no λ yet of its own fluid gets that of new fluid, a corner of a cell of another
     * one, such as of a wall that the fluid has just reached, the mean over the corners of its cells that have one. Who
     * has no cell of a fluid and does not belong to it has none. Collective.
     */
    static void complete(const FluidMesh<dim> &mesh, const Materials &materials,
                         const Migration<dim> &migration, ParticleCloud<dim> &cloud);

    /**
     * Let the time @p time_step pass, with the present velocities: a particle has the mean strain rate of its cells of the
     * fluid, weighted by their volumes, an isolated one none. Collective.
     */
    static void advance(const FluidMesh<dim> &mesh, const Materials &materials, const double time_step,
                        const Migration<dim> &migration, ParticleCloud<dim> &cloud);

    /// λ of the mesh's cells, zero where the fluid is not thixotropic; empty without a thixotropic fluid.
    static std::vector<double> of_cells(const FluidMesh<dim> &mesh, const Materials &materials,
                                        const ParticleCloud<dim> &cloud);
  };
} // namespace Lahar

#endif
