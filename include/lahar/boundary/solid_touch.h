// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_solid_touch_h
#define lahar_boundary_solid_touch_h

#include <lahar/boundary/wall_step.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <array>
#include <vector>

namespace Lahar
{
  /// A vertex of the fluid that lies on a facet of a solid along which it slides.
  template <int dim>
  struct SolidTouch
  {
    unsigned int vertex                   = 0;
    unsigned int facet                    = 0;  ///< of the walls of the step
    std::array<unsigned int, dim> corners = {}; ///< nodes of the solids
    double distance                       = 0.; ///< from the facet's plane, positive outside of the solid, m
    double area                           = 0.; ///< h^(dim−1) of the vertex, m² (m in the plane)
    double force = 0.; ///< of the fluid on the facet in the last step, N; 0 if it touches more

    /**
     * All of a mesh at the start of a step, by ascending vertices.
     * @param solid_facets the corners of the facets that follow the rigid ones in @p step.
     */
    static std::vector<SolidTouch> find(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                        const WallStep<dim> &step,
                                        const std::vector<std::array<unsigned int, dim>> &solid_facets);
  };
} // namespace Lahar

#endif
