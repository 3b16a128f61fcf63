// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_surface_chain_h
#define lahar_remeshing_surface_chain_h

#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/interface_faces.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace Lahar
{
  /// The neighbours of each particle along a plane free surface or interface: previous and next, with the fluid, or the
  /// first fluid, on the left.
  class SurfaceChain
  {
  public:
    /// The free surface.
    template <int dim>
    SurfaceChain(const FluidMesh<dim> &mesh, const unsigned int n_particles)
      : links(dim == 2 ? n_particles : 0, {{none, none}})
    {
      if constexpr (dim == 2)
        for (const BoundaryFace &face : mesh.boundary_faces())
          if (face.free_surface)
          {
            const Simplex<2> &cell = mesh.particle_cells()[face.cell];
            add(cell[(face.opposite + 1) % 3], cell[(face.opposite + 2) % 3]);
          }
    }

    /// The interfaces.
    template <int dim>
    SurfaceChain(const std::vector<InterfaceFace<dim>> &faces, const unsigned int n_particles)
      : links(dim == 2 ? n_particles : 0, {{none, none}})
    {
      if constexpr (dim == 2)
        for (const InterfaceFace<2> &face : faces)
          add(face.corners[0], face.corners[1]);
    }

    /**
     * The chain previous, a, b, next around the neighbours of an edge, in either order; empty if there is none, or one
     * of these is among the @p removed.
     */
    std::vector<unsigned int> around(const std::pair<unsigned int, unsigned int> &edge,
                                     const std::vector<double> &removed) const
    {
      auto [a, b] = edge;
      if (links[a][1] != b)
        std::swap(a, b);
      if (links[a][1] != b || links[b][0] != a)
        return {};
      const unsigned int previous = links[a][0], next = links[b][1];
      if (std::max(previous, next) >= links.size() || previous == next || removed[previous] > 0. ||
          removed[next] > 0.)
        return {};
      return {previous, a, b, next};
    }

  private:
    void add(const unsigned int from, const unsigned int to)
    {
      links[from][1] = (links[from][1] == none ? to : ambiguous);
      links[to][0]   = (links[to][0] == none ? from : ambiguous);
    }

    static constexpr unsigned int none = -1, ambiguous = -2;
    std::vector<std::array<unsigned, 2>> links;
  };
} // namespace Lahar

#endif
