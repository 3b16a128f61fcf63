// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_wall_step_h
#define lahar_boundary_wall_step_h

#include <lahar/boundary/boundary_motion.h>
#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>

#include <optional>
#include <vector>

namespace Lahar
{
  /**
   * The rigid walls during one time step: where they are at its start and at its end, and how fast they go. A boundary
   * goes from one to the other as a rigid body; its velocity at a point is the mean one of the step,
   * (x(t + Δt) − x(t))/Δt, so that it displaces just the volume that it passes over.
   */
  template <int dim>
  class WallStep
  {
  public:
    /// Walls that stand. They must outlive this object.
    explicit WallStep(const Walls<dim> &walls)
      : start(walls)
    {}

    /**
     * @param walls at the start; they must outlive this object.
     * @param end the same facets at the end.
     * @param motions by boundary, from the start to the end; none for one that stands.
     * @param length of the step, s.
     */
    WallStep(const Walls<dim> &walls, const Walls<dim> &end,
             const std::vector<std::optional<RigidMotion<dim>>> &motions, const double length);

    /// The walls at the end of the step.
    const Walls<dim> &end() const
    {
      return moved ? *moved : start;
    }

    /// Whether any boundary moves.
    bool any_moves() const
    {
      return moved.has_value();
    }

    bool moves(const unsigned int boundary) const
    {
      return any_moves() && motions[boundary].has_value();
    }

    bool facet_moves(const unsigned int facet) const
    {
      return any_moves() && moves(start.facets()[facet].boundary);
    }

    /// Where a point that goes with a boundary, at @p point at the start, is at the end.
    Point<dim> carried(const unsigned int boundary, const Point<dim> &point) const
    {
      return moves(boundary) ? (*motions[boundary])(point) : point;
    }

    /// Velocity of a boundary's point that is at @p point at the start of the step, m/s.
    Tensor<1, dim> velocity(const unsigned int boundary, const Point<dim> &point) const
    {
      return moves(boundary) ? Tensor<1, dim>((carried(boundary, point) - point) / length) : Tensor<1, dim>();
    }

    /// The same for the point that is at @p point at the end of the step.
    Tensor<1, dim> velocity_at_end(const unsigned int boundary, const Point<dim> &point) const
    {
      return moves(boundary) ? Tensor<1, dim>((point - motions[boundary]->inverse()(point)) / length)
                             : Tensor<1, dim>();
    }

    /// How fast a point, at @p point at the start, moves along a facet's normal at the end if it keeps its distance from
    /// the facet's plane, m/s.
    double normal_velocity(const unsigned int facet, const Point<dim> &point) const
    {
      return facet_moves(facet)
               ? (start.signed_distance(facet, point) - end().signed_distance(facet, point)) / length
               : 0.;
    }

    /// Signed distance of a point, at @p point at the start of the step, from a facet's plane then.
    double distance_at_start(const unsigned int facet, const Point<dim> &point) const
    {
      return start.signed_distance(facet, point);
    }

    /// Facets that a particle's way from @p a to @p b passes through, each in the frame of its boundary; see
    /// Walls::crossed().
    std::vector<unsigned int> crossed(const Point<dim> &a, const Point<dim> &b, const double tolerance,
                                      const double rim) const;

    /// Put the particles of walls that move where they are at the end; @p old_position is where all particles were.
    void carry_particles(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const;

  private:
    const Walls<dim> &start;
    std::optional<Walls<dim>> moved;
    std::vector<std::optional<RigidMotion<dim>>> motions;
    double length = 0.;
  };
} // namespace Lahar

#endif
