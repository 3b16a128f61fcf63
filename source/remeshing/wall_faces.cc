// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
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
      const auto &facets = cloud.contact_facets[cell[(face.opposite + 1) % (dim + 1)]];
      return std::any_of(facets.begin(), facets.end(), [&](const int facet) {
        for (unsigned int c = 0; c <= dim; ++c)
          if (c != face.opposite && !is_in_plane(facet, cell[c], cloud, walls))
            return false;
        return true;
      });
    }

    /// Call @p fulfils with the normals, towards the particle, of the facets that it is in contact with, until one does.
    template <int dim, typename Condition>
    bool any_normal(const unsigned int particle, const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                    const Condition &fulfils)
    {
      for (const int facet : cloud.contact_facets[particle])
        if (facet != ParticleCloud<dim>::no_facet &&
            static_cast<unsigned int>(facet) < walls.facets().size() &&
            fulfils((walls.signed_distance(facet, cloud.position[particle]) < 0. ? -1. : 1.) *
                    walls.normal(facet)))
          return true;
      return false;
    }

    /// Whether all corners of a face lie on a wall that goes on smoothly from one to the other, behind the face.
    template <int dim>
    bool lies_on_smooth_wall(const BoundaryFace &face, const Simplex<dim> &cell,
                             const ParticleCloud<dim> &cloud, const Walls<dim> &walls)
    {
      const Tensor<1, dim> inward = shape_gradients<dim>(
        corners_of<dim>(cell, cloud.position))[face.opposite];
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite && !any_normal(cell[c], cloud, walls, [&](const Tensor<1, dim> &normal) {
              return normal * inward > smooth_joint * inward.norm();
            }))
          return false;
      return true;
    }
  } // namespace



  template <int dim>
  std::vector<BoundaryFace> free_surface_faces(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                               const Walls<dim> &walls)
  {
    std::vector<BoundaryFace> result;
    for (const BoundaryFace &face : mesh.boundary_faces())
    {
      const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
      bool on_wall             = true;
      for (unsigned int c = 0; c <= dim; ++c)
        on_wall = on_wall && (c == face.opposite || cloud.in_contact(cell[c]));
      if (face.free_surface && !(on_wall && (lies_on_plane_wall<dim>(face, cell, cloud, walls) ||
                                             lies_on_smooth_wall<dim>(face, cell, cloud, walls))))
        result.push_back(face);
    }
    return result;
  }



  template <int dim>
  bool are_on_one_surface(const unsigned int a, const unsigned int b, const ParticleCloud<dim> &cloud,
                          const Walls<dim> &walls)
  {
    if (cloud.contact_facets[a] == cloud.contact_facets[b])
      return true;
    const auto all_go_on = [&](const unsigned int from, const unsigned int to) {
      return !any_normal(from, cloud, walls, [&](const Tensor<1, dim> &n) {
        return !any_normal(to, cloud, walls, [&](const Tensor<1, dim> &m) { return n * m > smooth_joint; });
      });
    };
    return cloud.in_contact(a) && cloud.in_contact(b) && all_go_on(a, b) && all_go_on(b, a);
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



  template bool are_on_one_surface(const unsigned int, const unsigned int, const ParticleCloud<2> &,
                                   const Walls<2> &);
  template bool are_on_one_surface(const unsigned int, const unsigned int, const ParticleCloud<3> &,
                                   const Walls<3> &);
  template void touch_plane_wall(const unsigned int, const std::pair<unsigned int, unsigned int> &,
                                 const Walls<2> &, ParticleCloud<2> &);
  template void touch_plane_wall(const unsigned int, const std::pair<unsigned int, unsigned int> &,
                                 const Walls<3> &, ParticleCloud<3> &);
  template std::vector<BoundaryFace> free_surface_faces(const FluidMesh<2> &, const ParticleCloud<2> &,
                                                        const Walls<2> &);
  template std::vector<BoundaryFace> free_surface_faces(const FluidMesh<3> &, const ParticleCloud<3> &,
                                                        const Walls<3> &);
} // namespace Lahar
