// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_thin_films_h
#define lahar_remeshing_thin_films_h

#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/migration.h>

namespace Lahar
{
  /**
   * In the plane, tear films of a fluid between others that are too thin for the mesh.
   *
   * A cell of a film has all of its corners on interfaces, and its height over one of its interface edges is the film's
   * thickness there. Where that is less than 0.18 h the cell goes over to the fluid behind this edge; of two such cells
   * side by side the thinner one does. Otherwise the film, whose edges the next triangulation keeps, would be drawn out to
   * cells without height, and the flow could not follow them. Corners of these cells that are left without an interface
   * belong to the fluid around them.
   *
   * For a mesh that is to be made anew: its cells' fluids and the parts of the @p cloud change, nothing else. Collective.
   */
  void tear_thin_films(const Migration<2> &migration, FluidMesh<2> &mesh, ParticleCloud<2> &cloud);
} // namespace Lahar

#endif
