// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_wall_separation_h
#define lahar_boundary_wall_separation_h

#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <optional>
#include <vector>

namespace Lahar
{
  /// By boundary: the normal tension that it bears before fluid leaves it, Pa; none where fluid does not. A boundary beyond
  /// the end has none.
  using TensileStrengths = std::vector<std::optional<double>>;

  /**
   * Fluid leaves walls that pull it: unilateral contact in the normal direction, explicit in time.
   *
   * The mean force R of the walls on a vertex in the last step is Σ λ_f n_f and what is along the facets f that it lies on,
   * n_f into the fluid: n_f·Σ_g λ_g n_g = n_f·R. The vertex leaves a facet where the tension is beyond what the surface
   * bears, −λ_f > σ A_f, σ its boundary's tensile strength and A_f the vertex's share of the mesh's faces on the facet. So
   * the pull of one step acts before fluid lets go. What has left lands again where it comes to the wall, see WallContact.
   */
  template <int dim>
  struct WallSeparation
  {
    /// Release this rank's own particles, before the next step; @p walls, @p mesh and @p cloud are those at the end of the
    /// last one. Copies on other ranks stay as they are. @return how many facets all ranks' particles have left. Collective.
    static unsigned int release(const TensileStrengths &strengths, const Walls<dim> &walls,
                                const FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud,
                                const MPI_Comm &communicator);
  };
} // namespace Lahar

#endif
