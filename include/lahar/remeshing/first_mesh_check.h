// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_first_mesh_check_h
#define lahar_remeshing_first_mesh_check_h

#include <lahar/geometry/walls.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>

namespace Lahar
{
  /**
   * What the first mesh shows of a case that will not be computed as it is meant. All functions are collective.
   */
  template <int dim>
  class FirstMeshCheck
  {
  public:
    /// A number of things, one of which is at a place.
    struct Places
    {
      double n = 0.;
      Point<dim> place;
    };

    /// The arguments must outlive this object.
    FirstMeshCheck(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                   const Migration<dim> &migration);

    /// Particles on @p walls that have cells on both sides of one facet: the two sides share their pressure.
    Places between_two_sides(const Walls<dim> &walls) const;

    /// Particles of parts of the fluid that have no free surface and touch no solid.
    Places enclosed() const;

    /**
     * The thinnest part of the fluid between two faces of its boundary that are nearly parallel (within 30°): how many
     * mesh sizes it is across, at most @p most, and a place on it. @p obstacles are the rigid walls and the solids'
     * contours.
     */
    std::pair<double, Point<dim>> thinnest(const Walls<dim> &obstacles, const double most) const;

  private:
    const ParticleCloud<dim> &cloud;
    const FluidMesh<dim> &mesh;
    const Migration<dim> &migration;
  };
} // namespace Lahar

#endif
