// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/sliding_contact.h>
#include <lahar/geometry/facet_geometry.h>
#include <lahar/geometry/symmetry.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Lahar
{
  namespace
  {
    /// A face belongs to a facet if the cosine of the angle between their normals exceeds this.
    constexpr double least_facet_cosine = 0.7;

    /// What touches another boundary belongs to a face if it is nearer to its facet than this times its spacing.
    constexpr double touching_distance = 0.1;

    /// How far e comes in an iteration.
    constexpr double excess_part = 0.5;

    /// What is nearer to one than this is one.
    constexpr double unit_rounding = 1e-10;
  } // namespace



  template <int dim>
  SlidingForce<dim> SlidingContact<dim>::force(const Tensor<1, dim> &velocity, const double pressure,
                                               const SlidingState<dim> &state) const
  {
    const SymmetricTensor<2, dim> tangential = unit_symmetric_tensor<dim>() -
                                               symmetrize(outer_product(normal, normal));
    const Tensor<1, dim> s                = tangential * (velocity - wall_velocity);
    const double normal_stress            = state.excess_stress - pressure - pore_pressure;
    const SurfaceLaw::Resistance resisted = law->resistance(std::max(normal_stress, 0.));
    SlidingForce<dim> result;
    result.value       = resisted.viscous * s;
    result.by_velocity = resisted.viscous * Tensor<2, dim>(tangential);
    const double tau   = resisted.threshold;
    if (tau > 0.)
    {
      const Tensor<1, dim> lambda = tangential * state.multiplier;
      const Tensor<1, dim> Y      = tau * lambda + stiffness * s;
      const double chi            = Y.norm();
      Tensor<1, dim> by_threshold = lambda;
      if (chi <= tau || state.held)
      {
        result.multiplier = Y / tau;
        result.by_velocity += stiffness * Tensor<2, dim>(tangential);
      }
      else
      {
        const Tensor<1, dim> direction  = Y / chi;
        const Tensor<2, dim> transverse = Tensor<2, dim>(tangential) - outer_product(direction, direction);
        result.multiplier               = direction;
        result.by_velocity += tau * stiffness / chi * transverse;
        by_threshold = direction + tau / chi * (transverse * lambda);
      }
      result.value += tau * result.multiplier;
      if (normal_stress > 0.)
        result.by_pressure = -resisted.threshold_derivative * by_threshold;
    }
    result.value *= area;
    result.by_velocity *= area;
    result.by_pressure *= area;
    return result;
  }



  template <int dim>
  void SlidingContact<dim>::iterate(const Tensor<1, dim> &velocity, const double pressure,
                                    const Tensor<1, dim> &reaction, const bool follows,
                                    SlidingState<dim> &state) const
  {
    const Tensor<1, dim> P = force(velocity, pressure, state).multiplier;
    const bool slides      = P.norm() >= 1. - unit_rounding;
    state.held             = slides && P * state.direction < 0.;
    state.direction        = slides && !state.held ? P : Tensor<1, dim>();
    if (follows)
      state.excess_stress += excess_part *
                             (std::max(reaction * normal / area, 0.) + pressure - state.excess_stress);
  }



  template <int dim>
  std::vector<SlidingContact<dim>>
  SlidingContact<dim>::find(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                            const WallStep<dim> &step, const std::vector<const SurfaceLaw *> &laws)
  {
    std::vector<SlidingContact> result;
    if (std::none_of(laws.begin(), laws.end(), [](const SurfaceLaw *law) { return law->resists(); }))
      return result;
    const Walls<dim> &walls = step.end();
    // The facet of a boundary on which a particle slides and to which a face is parallel.
    const auto facet_of = [&](const unsigned int particle, const unsigned int boundary,
                              const Tensor<1, dim> &direction) {
      for (const int facet : cloud.contact_facets[particle])
        if (facet != ParticleCloud<dim>::no_facet && walls.facets()[facet].boundary == boundary &&
            std::abs(walls.normal(facet) * direction) > least_facet_cosine)
          return facet;
      return ParticleCloud<dim>::no_facet;
    };

    std::map<std::pair<unsigned int, unsigned int>, SlidingContact> contacts; // by vertex and boundary
    for (const BoundaryFace &face : mesh.boundary_faces())
    {
      std::vector<unsigned int> vertices;
      std::array<Point<dim>, dim> corners;
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
        {
          vertices.push_back(mesh.cells()[face.cell][c]);
          corners[vertices.size() - 1] = cloud.position[mesh.particle(vertices.back())];
        }
      const Point<dim> inside = cloud.position[mesh.particle(mesh.cells()[face.cell][face.opposite])];
      const Tensor<1, dim> area_normal = area_vector<dim>(corners);
      const double area                = area_normal.norm();
      if (!(area > 0.))
        continue;
      for (unsigned int boundary = 0; boundary < laws.size(); ++boundary)
      {
        if (!laws[boundary]->resists())
          continue;
        std::vector<int> facets;
        int some_facet = ParticleCloud<dim>::no_facet;
        for (const unsigned int v : vertices)
        {
          facets.push_back(cloud.kind[mesh.particle(v)] == ParticleKind::fluid
                             ? facet_of(mesh.particle(v), boundary, area_normal / area)
                             : ParticleCloud<dim>::no_facet);
          if (facets.back() != ParticleCloud<dim>::no_facet)
            some_facet = facets.back();
        }
        if (some_facet == ParticleCloud<dim>::no_facet)
          continue;
        bool all_touch = true;
        for (unsigned int k = 0; k < dim; ++k)
        {
          const unsigned int i = mesh.particle(vertices[k]);
          all_touch            = all_touch &&
                      (facets[k] != ParticleCloud<dim>::no_facet ||
                       ((cloud.kind[i] != ParticleKind::fluid || cloud.in_contact(i)) &&
                        std::abs(walls.signed_distance(some_facet, step.carried(boundary, corners[k]))) <
                          touching_distance * cloud.spacing[i]));
        }
        if (!all_touch)
          continue;
        double sum_of_radii = 0.;
        for (const Point<dim> &corner : corners)
          sum_of_radii += corner[0];
        for (unsigned int k = 0; k < dim; ++k)
          if (facets[k] != ParticleCloud<dim>::no_facet)
          {
            const auto contact = contacts.try_emplace({vertices[k], boundary}).first;
            if (contact->second.area == 0.)
            {
              const Tensor<1, dim> &n = walls.normal(facets[k]);
              contact->second         = {vertices[k],
                                         laws[boundary],
                                         0.,
                                 n * (inside - corners[k]) > 0. ? n : -n,
                                         step.velocity(boundary, corners[k]),
                                         0.,
                                         static_cast<unsigned int>(facets[k])};
            }
            contact->second.area += face_share<dim>(area, sum_of_radii, corners[k][0]);
          }
      }
    }
    for (const auto &[key, contact] : contacts)
      result.push_back(contact);
    return result;
  }



  template struct SlidingContact<2>;
  template struct SlidingContact<3>;
} // namespace Lahar
