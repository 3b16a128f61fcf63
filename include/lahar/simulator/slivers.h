// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_slivers_h
#define lahar_simulator_slivers_h

#include <lahar/remeshing/fluid_mesh.h>

#include <vector>

namespace Lahar
{
  /**
   * Slivers: tetrahedra whose four corners lie near one plane though no two of them are near each other. A Delaunay
   * triangulation in space is full of them, inside the fluid too; in the plane there are none.
   *
   * Their height says nothing about the fluid: a motion that is not linear across them turns them inside out in a step,
   * and nothing is wrong with the cells around. Summed over a mesh whose surface does not cross itself, signed volumes are
   * the volume inside that surface, whatever the signs are. So a sliver keeps the shape of the start of the step for its
   * masses and its stress, while its volume and its area vectors in the mass equation and in the pressure's force are
   * those of its corners at the end (FlatPressureDivergence): it may turn inside out, stops nothing and loses no volume.
   *
   * @return by cell of @p mesh whether V < 0.2 l³/(6 √2), l the mean length of its edges, and it is no contact: at most one
   * corner is a particle of a wall or of a solid. Contact by cells may not turn inside out, or fluid would pass through the
   * wall; particles that land on a wall do not pass through it whatever their cells do (WallContact).
   */
  template <int dim>
  std::vector<bool> find_slivers(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud);
} // namespace Lahar

#endif
