// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/mpi.h>

#include <lahar/boundary/normal_parts.h>
#include <lahar/boundary/wall_separation.h>
#include <lahar/geometry/facet_geometry.h>
#include <lahar/geometry/symmetry.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace Lahar
{
  namespace
  {
    /// A face lies on a facet if the cosine of the angle between their normals exceeds this …
    constexpr double least_cosine = 0.7;
    /// … and its corners are nearer to its plane than this times their spacing.
    constexpr double on_plane = 0.1;

    /// Pull below this part of the largest normal force is rounding.
    constexpr double pull_rounding = 1e-6;

    /// Whether an entry of ParticleCloud::contact_facets is a facet of a wall; those behind them are of solids.
    template <int dim>
    bool is_of_wall(const int facet, const Walls<dim> &walls)
    {
      return facet != ParticleCloud<dim>::no_facet &&
             static_cast<unsigned int>(facet) < walls.facets().size();
    }

    /// By particle and facet that separates: A_f.
    template <int dim>
    std::map<std::pair<unsigned int, unsigned int>, double>
    find_areas(const TensileStrengths &strengths, const Walls<dim> &walls, const FluidMesh<dim> &mesh,
               const ParticleCloud<dim> &cloud)
    {
      std::map<std::pair<unsigned int, unsigned int>, double> areas;
      for (const BoundaryFace &face : mesh.boundary_faces())
      {
        std::array<unsigned int, dim> particles;
        std::array<Point<dim>, dim> corners;
        double sum_of_radii = 0.;
        for (unsigned int c = 0, k = 0; c <= dim; ++c)
          if (c != face.opposite)
          {
            particles[k] = mesh.particle_cells()[face.cell][c];
            corners[k]   = cloud.position[particles[k]];
            sum_of_radii += corners[k++][0];
          }
        const Tensor<1, dim> area_normal = area_vector<dim>(corners);
        const double area                = area_normal.norm();
        if (!(area > 0.))
          continue;
        for (unsigned int k = 0; k < dim; ++k)
          for (const int facet : cloud.contact_facets[particles[k]])
            if (is_of_wall(facet, walls) && strengths[walls.facets()[facet].boundary] &&
                cloud.kind[particles[k]] == ParticleKind::fluid &&
                std::abs(walls.normal(facet) * area_normal) > least_cosine * area &&
                std::all_of(particles.begin(), particles.end(), [&](const unsigned int i) {
                  return (cloud.kind[i] != ParticleKind::fluid || cloud.in_contact(i)) &&
                         std::abs(walls.signed_distance(facet, cloud.position[i])) <
                           on_plane * cloud.spacing[i];
                }))
              areas[{particles[k], facet}] += face_share<dim>(area, sum_of_radii, corners[k][0]);
      }
      return areas;
    }

    /// λ of the facets that a particle lies on, in their order.
    template <int dim>
    std::vector<double> normal_forces(const Walls<dim> &walls, const ParticleCloud<dim> &cloud,
                                      const unsigned int particle, const std::vector<unsigned int> &facets)
    {
      std::vector<Tensor<1, dim>> normals;
      for (const unsigned int facet : facets)
        normals.push_back((walls.signed_distance(facet, cloud.position[particle]) < 0. ? -1. : 1.) *
                          walls.normal(facet));
      return normal_parts(normals, cloud.reaction[particle]);
    }
  } // namespace



  template <int dim>
  unsigned int WallSeparation<dim>::release(const TensileStrengths &strengths, const Walls<dim> &walls,
                                            const FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud,
                                            const MPI_Comm &communicator)
  {
    if (std::none_of(strengths.begin(), strengths.end(),
                     [](const auto &strength) { return strength.has_value(); }))
      return 0;
    const auto areas = find_areas(strengths, walls, mesh, cloud);
    struct Pull
    {
      unsigned int particle, facet;
      double force;
    };
    std::vector<Pull> pulls;
    double largest = 0.;
    for (const unsigned int i : mesh.particles())
    {
      if (!cloud.is_own(i) || cloud.kind[i] != ParticleKind::fluid || !cloud.in_contact(i))
        continue;
      std::vector<unsigned int> facets;
      for (const int facet : cloud.contact_facets[i])
        if (is_of_wall(facet, walls))
          facets.push_back(facet);
      if (facets.empty())
        continue;
      const std::vector<double> forces = normal_forces(walls, cloud, i, facets);
      for (unsigned int k = 0; k < facets.size(); ++k)
      {
        largest = std::max(largest, std::abs(forces[k]));
        if (strengths[walls.facets()[facets[k]].boundary] && forces[k] < 0.)
          pulls.push_back({i, facets[k], -forces[k]});
      }
    }
    largest                 = Utilities::MPI::max(largest, communicator);
    unsigned int n_released = 0;
    for (const Pull &pull : pulls)
    {
      const auto area    = areas.find({pull.particle, pull.facet});
      const double borne = (area == areas.end() ? 0. : area->second) *
                           *strengths[walls.facets()[pull.facet].boundary];
      auto &slots = cloud.contact_facets[pull.particle];
      if (!(pull.force > borne + pull_rounding * largest))
        continue;
      std::replace(slots.begin(), slots.end(), static_cast<int>(pull.facet), ParticleCloud<dim>::no_facet);
      std::sort(slots.begin(), slots.end(), std::greater<int>());
      if (!cloud.in_contact(pull.particle))
        cloud.reaction[pull.particle] = Tensor<1, dim>(); // the mean of later contacts knows nothing of it
      ++n_released;
    }
    return Utilities::MPI::sum(n_released, communicator);
  }



  template struct WallSeparation<2>;
  template struct WallSeparation<3>;
} // namespace Lahar
