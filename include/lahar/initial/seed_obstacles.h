// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_seed_obstacles_h
#define lahar_initial_seed_obstacles_h

#include <lahar/geometry/fluid_shape.h>
#include <lahar/initial/contact_at_start.h>

#include <vector>

namespace Lahar
{
  /// What may keep the particles of bodies of fluid from their places.
  template <int dim>
  class SeedObstacles
  {
  public:
    /// @p covered facets carry particles all over, on @p open ones fluid lands. Bodies and h must outlive this object.
    SeedObstacles(const typename FluidShape<dim>::Bodies &bodies, const MeshSize<dim> &h,
                  const std::vector<WallFacet<dim>> &covered, const std::vector<WallFacet<dim>> &open)
      : bodies(bodies)
      , h(h)
      , covered(covered)
      , open(open)
    {}

    /// Where @p point of a body is put.
    Point<dim> place(const Point<dim> &point, const unsigned int body) const
    {
      return bodies[body]->onto_walls(point, open, h(point), reach(point, body));
    }

    /// Whether a body's point touches a wall or solid that carries particles.
    bool is_covered(const Point<dim> &point, const unsigned int body) const
    {
      return is_near(covered, point, reach(point, body));
    }

    /// Whether a particle of none of the bodies is in the way: in the body's region or on its contour.
    bool blocks(const Point<dim> &particle, const Point<dim> &point, const unsigned int body) const
    {
      return is_seen(particle, point) && bodies[body]->signed_distance(particle) < reach(point, body);
    }

    /// Whether one of a body is: in the other body's region; of the body's own, whose two sides may come near to each
    /// other, one that stands very near.
    bool blocks(const Point<dim> &particle, const unsigned int of_body, const Point<dim> &point,
                const unsigned int body) const
    {
      return is_seen(particle, point) &&
             (of_body == body
                ? particle.distance(point) < contact * h(point)
                : bodies[body]->signed_distance(particle) < touching * h(point) + bodies[body]->roughness());
    }

  private:
    double reach(const Point<dim> &point, const unsigned int body) const
    {
      return contact * h(point) + bodies[body]->roughness();
    }

    bool is_seen(const Point<dim> &particle, const Point<dim> &point) const
    {
      return open.crossed(particle, point, 0., touching * h(point)).empty();
    }

    const typename FluidShape<dim>::Bodies &bodies;
    const MeshSize<dim> &h;
    Walls<dim> covered, open;
  };
} // namespace Lahar

#endif
