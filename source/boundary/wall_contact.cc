// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/wall_contact.h>

#include <algorithm>
#include <limits>

namespace Lahar
{
  namespace
  {
    /// A particle nearer to a wall than this times its spacing is in contact.
    constexpr double contact_distance = 0.1;

    /// Two normals span two directions if the sine of their angle exceeds this.
    constexpr double parallel_tolerance = 1e-3;

    /// Parts of the walls' speeds that are none.
    constexpr double speed_rounding = 1e-6;
  } // namespace



  template <int dim>
  void WallContact<dim>::attach(const unsigned int particle, const unsigned int facet, const int side,
                                ParticleCloud<dim> &cloud) const
  {
    auto &slots = cloud.contact_facets[particle];
    if (std::find(slots.begin(), slots.end(), static_cast<int>(facet)) != slots.end())
      return;
    const auto free_slot = std::find(slots.begin(), slots.end(), ParticleCloud<dim>::no_facet);
    if (free_slot == slots.end())
      return;
    // A facet in the plane of those in contact adds no direction; in 3D, where facets of one plane meet, it would take
    // the slot of one that does.
    const NodeConstraint<dim> before = sliding_at_end(particle, cloud);
    *free_slot                       = facet;
    if (sliding_at_end(particle, cloud).n_fixed == before.n_fixed)
    {
      *free_slot = ParticleCloud<dim>::no_facet;
      return;
    }

    // Move the particle along the directions that its other facets leave free.
    Tensor<1, dim> direction = walls.normal(facet);
    for (unsigned int a = 0; a < before.n_fixed; ++a)
      direction -= (walls.normal(facet) * before.frame[a]) * before.frame[a];
    const double slope = direction * walls.normal(facet);
    if (slope > parallel_tolerance * parallel_tolerance)
      cloud.position[particle] += (side * contact_offset * cloud.spacing[particle] -
                                   walls.signed_distance(facet, cloud.position[particle])) /
                                  slope * direction;

    if (const int sticking = sticking_facet(particle, cloud); sticking != ParticleCloud<dim>::no_facet)
    {
      cloud.velocity[particle]     = step.facet_velocity_at_end(sticking, cloud.position[particle]);
      cloud.acceleration[particle] = Tensor<1, dim>();
      cloud.algorithmic_acceleration[particle] = Tensor<1, dim>();
      return;
    }
    const NodeConstraint<dim> fixed = sliding_at_end(particle, cloud);
    for (unsigned int a = 0; a < fixed.n_fixed; ++a)
    {
      const Tensor<1, dim> &normal = fixed.frame[a];
      cloud.velocity[particle] -= ((cloud.velocity[particle] - fixed.velocity) * normal) * normal;
      cloud.acceleration[particle] -= (cloud.acceleration[particle] * normal) * normal;
      cloud.algorithmic_acceleration[particle] -= (cloud.algorithmic_acceleration[particle] * normal) *
                                                  normal;
    }
  }



  template <int dim>
  void WallContact<dim>::attach_near(const unsigned int particle, const double distance,
                                     const std::function<bool(const unsigned int, const int)> &meets,
                                     ContactSides<dim> &sides, ParticleCloud<dim> &cloud) const
  {
    const Point<dim> &position = cloud.position[particle];
    const auto &slots          = cloud.contact_facets[particle];
    for (const unsigned int facet : walls.near(position, distance))
      if (walls.facets()[facet].lands && std::abs(walls.signed_distance(facet, position)) < distance &&
          walls.is_above(facet, position, 1e-3 * cloud.spacing[particle]) &&
          !walls.is_hidden(facet, position))
      {
        const int side = sides.find(facet, side_of(facet, position));
        if ((separates(facet) && !meets(facet, side)) ||
            std::any_of(slots.begin(), slots.end(), [&](const int from) {
              // To what it sticks to it sticks at an edge, too, which so holds its cells off the body.
              return sides.goes_on(from, facet, side) ||
                     (!walls.facets()[facet].sticks && sides.is_round_edge(from, facet));
            }))
          continue;
        attach(particle, facet, side, cloud);
        sides.add(facet, side);
      }
  }



  template <int dim>
  void WallContact<dim>::initialize(ParticleCloud<dim> &cloud) const
  {
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.kind[i] == ParticleKind::fluid)
      {
        ContactSides<dim> sides(step);
        attach_near(
          i, 1e-3 * cloud.spacing[i], [](const unsigned int, const int) { return true; }, sides, cloud);
      }
  }



  template <int dim>
  void WallContact<dim>::update(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud,
                                const std::vector<bool> &flies) const
  {
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      if (cloud.kind[i] != ParticleKind::fluid)
        continue;
      const double h = cloud.spacing[i];

      auto &slots       = cloud.contact_facets[i];
      const auto before = slots;
      ContactSides<dim> sides(step);
      for (int &facet : slots)
        if (facet != ParticleCloud<dim>::no_facet)
        {
          // It may have been moved through what it was in contact with since.
          sides.add(facet, side_at_start(facet, old_position[i]));
          if ((!flies.empty() && flies[i]) || !walls.is_above(facet, cloud.position[i], 1e-3 * h) ||
              std::abs(walls.signed_distance(facet, cloud.position[i])) > 1e-3 * h)
            facet = ParticleCloud<dim>::no_facet;
        }
      std::sort(slots.begin(), slots.end(), std::greater<int>());
      put_on_solids(i, old_position[i], cloud);

      // Along a smooth surface it leaves the facet behind for the one that it comes to.
      const auto come_to = [&](const unsigned int facet, const int side) {
        for (int &from : slots)
          if (sides.goes_on(from, facet, side))
            from = ParticleCloud<dim>::no_facet;
        std::sort(slots.begin(), slots.end(), std::greater<int>());
        attach(i, facet, side, cloud);
        sides.add(facet, side);
      };
      // The first facet on its way stops it there; from then on it may meet others.
      std::vector<unsigned int> met;
      for (bool any = true; any;)
      {
        any               = false;
        double nearest    = std::numeric_limits<double>::max();
        unsigned int next = 0;
        for (const unsigned int facet : step.crossed(old_position[i], cloud.position[i], 0., 1e-3 * h))
          if (walls.facets()[facet].lands && std::find(met.begin(), met.end(), facet) == met.end() &&
              std::find(slots.begin(), slots.end(), static_cast<int>(facet)) == slots.end())
          {
            const double before = std::abs(step.distance_at_start(facet, old_position[i])),
                         after  = std::abs(walls.signed_distance(facet, cloud.position[i]));
            if (const double part = before > 0. ? before / (before + after) : 0.; part < nearest)
            {
              nearest = part;
              next    = facet;
            }
            any = true;
          }
        if (!any)
          break;
        met.push_back(next);
        const int side = sides.find(next, side_at_start(next, old_position[i]));
        // Beyond a bulge the facets that it comes from are above it.
        for (const unsigned int from : sides.left_over_bulge(next, side))
          met.push_back(from);
        come_to(next, side);
      }
      // Put onto a facet beyond its rim it may be behind the next one, round whose rim its way has led.
      for (unsigned int round = 0; round < dim; ++round)
        if (const auto facet = sides.passed_by(cloud.position[i], old_position[i].distance(cloud.position[i]),
                                               slots))
          come_to(facet->first, facet->second);
        else
          break;
      // Along a smooth surface it goes on; else it comes to a wall that it moves towards.
      const auto meets = [&](const unsigned int facet, const int side) {
        const Tensor<1, dim> &normal = walls.normal(facet);
        return std::any_of(before.begin(), before.end(),
                           [&](const int from) { return sides.goes_on(from, facet, side); }) ||
               side * (normal * (cloud.velocity[i] -
                                 step.velocity_at_end(walls.facets()[facet].boundary, cloud.position[i]))) <
                 0.;
      };
      attach_near(i, contact_distance * h, meets, sides, cloud);
    }
  }



  template <int dim>
  void WallContact<dim>::put_on_solids(const unsigned int particle, const Point<dim> &old_position,
                                       ParticleCloud<dim> &cloud) const
  {
    const auto &slots = cloud.contact_facets[particle];
    if (std::none_of(slots.begin(), slots.end(), [&](const int facet) {
          return facet != ParticleCloud<dim>::no_facet && step.deforms(facet);
        }))
      return;
    // In a corner that is no right angle the one facet moves it off the others.
    for (unsigned int round = 0; round < 2 * dim; ++round)
      for (const int facet : slots)
        if (facet != ParticleCloud<dim>::no_facet)
        {
          const double height = side_at_start(facet, old_position) * contact_offset * cloud.spacing[particle];
          cloud.position[particle] += (height - walls.signed_distance(facet, cloud.position[particle])) *
                                      walls.normal(facet);
        }
  }



  template <int dim>
  bool WallContact<dim>::separates(const unsigned int facet) const
  {
    const unsigned int boundary = walls.facets()[facet].boundary;
    return boundary < strengths.size() && strengths[boundary].has_value();
  }



  template <int dim>
  int WallContact<dim>::side_of(const unsigned int facet, const Point<dim> &point) const
  {
    return walls.signed_distance(facet, point) < 0. && !step.deforms(facet) ? -1 : 1;
  }



  template <int dim>
  int WallContact<dim>::side_at_start(const unsigned int facet, const Point<dim> &point) const
  {
    return step.distance_at_start(facet, point) < 0. && !step.deforms(facet) ? -1 : 1;
  }



  template <int dim>
  int WallContact<dim>::sticking_facet(const unsigned int particle, const ParticleCloud<dim> &cloud) const
  {
    for (const int facet : cloud.contact_facets[particle])
      if (facet != ParticleCloud<dim>::no_facet && walls.facets()[facet].sticks)
        return facet;
    return ParticleCloud<dim>::no_facet;
  }



  template <int dim>
  NodeConstraint<dim> WallContact<dim>::constraint(const unsigned int particle,
                                                   const ParticleCloud<dim> &cloud) const
  {
    unsigned int boundary = cloud.part[particle];
    bool of_wall          = cloud.kind[particle] == ParticleKind::wall;
    if (cloud.kind[particle] == ParticleKind::fluid)
    {
      const auto speed = [&](const unsigned int facet) {
        return step.normal_velocity(facet, cloud.position[particle]);
      };
      const int sticking = sticking_facet(particle, cloud);
      // What slides along a solid gives way to it along the wall.
      const bool beside_solid = std::any_of(cloud.contact_facets[particle].begin(),
                                            cloud.contact_facets[particle].end(), [&](const int facet) {
                                              return facet != ParticleCloud<dim>::no_facet &&
                                                     step.deforms(facet);
                                            });
      if (sticking == ParticleCloud<dim>::no_facet || beside_solid)
        return sliding(particle, cloud, speed, false);
      of_wall  = true;
      boundary = walls.facets()[sticking].boundary;
      // What another wall pushes along the one that it sticks to slides on both.
      const Tensor<1, dim> v = step.velocity(boundary, cloud.position[particle]);
      for (const int facet : cloud.contact_facets[particle])
        if (facet != ParticleCloud<dim>::no_facet && walls.facets()[facet].boundary != boundary)
        {
          const Tensor<1, dim> u = step.velocity(walls.facets()[facet].boundary, cloud.position[particle]);
          if (std::abs(walls.normal(facet) * v - speed(facet)) > speed_rounding * (v.norm() + u.norm()))
            return sliding(particle, cloud, speed, false);
        }
    }
    NodeConstraint<dim> result;
    result.n_fixed = dim;
    if (of_wall && step.moves(boundary))
    {
      result.moves    = true;
      result.velocity = step.velocity(boundary, cloud.position[particle]);
    }
    return result;
  }



  template <int dim>
  NodeConstraint<dim> WallContact<dim>::sliding_at_end(const unsigned int particle,
                                                       const ParticleCloud<dim> &cloud) const
  {
    return sliding(
      particle, cloud,
      [&](const unsigned int facet) {
        return walls.normal(facet) * step.facet_velocity_at_end(facet, cloud.position[particle]);
      },
      true);
  }



  template <int dim>
  NodeConstraint<dim> WallContact<dim>::sliding(const unsigned int particle, const ParticleCloud<dim> &cloud,
                                                const std::function<double(const unsigned int)> &speed,
                                                const bool with_solids) const
  {
    NodeConstraint<dim> result;
    if (!cloud.in_contact(particle))
      return result;

    // Gram–Schmidt: the normals first, then coordinate directions to complete the frame.
    unsigned int n_rows = 0;
    Tensor<1, dim> velocity; // in the directions so far
    const auto add = [&](Tensor<1, dim> direction, const double tolerance, double along) {
      for (unsigned int a = 0; a < n_rows; ++a)
      {
        const double share = direction * result.frame[a];
        direction -= share * result.frame[a];
        along -= share * (velocity * result.frame[a]);
      }
      if (n_rows < dim && direction.norm() > tolerance)
      {
        result.frame[n_rows] = direction / direction.norm();
        if (along != 0.)
          velocity += along / direction.norm() * result.frame[n_rows];
        ++n_rows;
      }
    };
    for (const int facet : cloud.contact_facets[particle])
      if (facet != ParticleCloud<dim>::no_facet && (with_solids || !step.deforms(facet)))
      {
        add(walls.normal(facet), parallel_tolerance, speed(facet));
        result.moves = result.moves || step.facet_moves(facet);
      }
    result.n_fixed  = n_rows;
    result.velocity = velocity;
    while (n_rows < dim)
    {
      // The coordinate direction that the rows so far leave most of.
      Tensor<1, dim> best;
      double best_norm = -1.;
      for (unsigned int d = 0; d < dim; ++d)
      {
        Tensor<1, dim> rest;
        rest[d] = 1.;
        for (unsigned int a = 0; a < n_rows; ++a)
          rest -= (rest * result.frame[a]) * result.frame[a];
        if (rest.norm() > best_norm)
        {
          best_norm = rest.norm();
          best      = rest;
        }
      }
      add(best, 0., 0.);
    }
    return result;
  }



  template class WallContact<2>;
  template class WallContact<3>;
} // namespace Lahar
