// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/wall_faces.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// Particles in contact lie this times their spacing off a plane at most.
    constexpr double plane = 1e-6;

    /// Whether it is the number of a facet in whose plane the particle lies; those of solids may be behind @p walls.
    template <int dim>
    bool is_in_plane(const int facet, const unsigned int particle, const ParticleCloud<dim> &cloud,
                     const Walls<dim> &walls)
    {
      return facet != ParticleCloud<dim>::no_facet &&
             static_cast<unsigned int>(facet) < walls.facets().size() &&
             std::abs(walls.signed_distance(facet, cloud.position[particle])) <
               plane * cloud.spacing[particle];
    }

    template <int dim>
    bool lies_on_plane_wall(const BoundaryFace &face, const Simplex<dim> &cell,
                            const ParticleCloud<dim> &cloud, const Walls<dim> &walls)
    {
      const auto all_corners = [&](const auto &fulfil) {
        for (unsigned int c = 0; c <= dim; ++c)
          if (c != face.opposite && !fulfil(cell[c]))
            return false;
        return true;
      };
      if (!all_corners([&](const unsigned int i) { return cloud.in_contact(i); }))
        return false;
      const auto &facets = cloud.contact_facets[cell[(face.opposite + 1) % (dim + 1)]];
      return std::any_of(facets.begin(), facets.end(), [&](const int facet) {
        return all_corners([&](const unsigned int i) { return is_in_plane(facet, i, cloud, walls); });
      });
    }
  } // namespace



  template <int dim>
  std::vector<BoundaryFace> free_surface_faces(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                               const Walls<dim> &walls)
  {
    std::vector<BoundaryFace> result;
    for (const BoundaryFace &face : mesh.boundary_faces())
      if (face.free_surface && !lies_on_plane_wall<dim>(face, mesh.particle_cells()[face.cell], cloud, walls))
        result.push_back(face);
    return result;
  }



  template <int dim>
  void touch_plane_wall(const unsigned int particle, const std::pair<unsigned int, unsigned int> &parents,
                        const Walls<dim> &walls, ParticleCloud<dim> &cloud)
  {
    const auto [a, b] = parents;
    if (cloud.in_contact(particle) || !cloud.in_contact(a) || !cloud.in_contact(b))
      return;
    for (const auto &[from, to] : {std::make_pair(a, b), std::make_pair(b, a)})
      for (const int facet : cloud.contact_facets[from])
        if (is_in_plane(facet, to, cloud, walls) && walls.is_above(facet, cloud.position[particle], 0.))
        {
          cloud.contact_facets[particle][0] = facet;
          return;
        }
  }



  template void touch_plane_wall(const unsigned int, const std::pair<unsigned int, unsigned int> &,
                                 const Walls<2> &, ParticleCloud<2> &);
  template void touch_plane_wall(const unsigned int, const std::pair<unsigned int, unsigned int> &,
                                 const Walls<3> &, ParticleCloud<3> &);
  template std::vector<BoundaryFace> free_surface_faces(const FluidMesh<2> &, const ParticleCloud<2> &,
                                                        const Walls<2> &);
  template std::vector<BoundaryFace> free_surface_faces(const FluidMesh<3> &, const ParticleCloud<3> &,
                                                        const Walls<3> &);
} // namespace Lahar
