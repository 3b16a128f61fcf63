// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_wall_step_h
#define lahar_boundary_wall_step_h

#include <lahar/boundary/boundary_motion.h>
#include <lahar/geometry/walls.h>
#include <lahar/particles/particle_cloud.h>

#include <memory>
#include <optional>
#include <vector>

namespace Lahar
{
  /**
   * The rigid walls during one time step: where they are at its start and at its end, and how fast they go. A boundary
   * goes from one to the other as a rigid body; its velocity at a point is the mean one of the step,
   * (x(t + Δt) − x(t))/Δt, so that it displaces just the volume that it passes over.
   *
   * Facets of solids on which fluid lands may stand behind those of the walls. They deform: each takes what is on it along
   * by the shares that its corners have of the foot.
   */
  template <int dim>
  class WallStep
  {
  public:
    /// Walls that stand. They must outlive this object.
    explicit WallStep(const Walls<dim> &walls)
      : start(&walls)
      , n_rigid(walls.facets().size())
    {}

    /**
     * @param walls at the start; they must outlive this object.
     * @param end the same facets at the end.
     * @param motions by boundary, from the start to the end; none for one that stands.
     * @param length of the step, s.
     */
    WallStep(const Walls<dim> &walls, const Walls<dim> &end,
             const std::vector<std::optional<RigidMotion<dim>>> &motions, const double length);

    /**
     * The same step with facets of solids behind those of the walls.
     * @param at_start, at_end the same facets; before the end is known they may be equal.
     * @param step_length s.
     */
    WallStep with_solids(const std::vector<WallFacet<dim>> &at_start,
                         const std::vector<WallFacet<dim>> &at_end, const double step_length) const;

    /// The walls at the end of the step.
    const Walls<dim> &end() const
    {
      return moved ? *moved : *start;
    }

    /// Whether a facet is one of a solid.
    bool deforms(const unsigned int facet) const
    {
      return facet >= n_rigid;
    }

    /// How many facets are none of solids.
    unsigned int n_rigid_facets() const
    {
      return n_rigid;
    }

    /// Whether any boundary moves.
    bool any_moves() const
    {
      return moved.has_value();
    }

    bool moves(const unsigned int boundary) const
    {
      return any_moves() && boundary < motions.size() && motions[boundary].has_value();
    }

    /// Whether a facet moves as a rigid body.
    bool facet_moves(const unsigned int facet) const
    {
      return any_moves() && moves(start->facets()[facet].boundary);
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

    /// velocity_at_end() of the boundary of a facet or, of a facet that deforms, of its point below @p point.
    Tensor<1, dim> facet_velocity_at_end(const unsigned int facet, const Point<dim> &point) const;

    /// How fast a point, at @p point at the start, moves along a facet's normal at the end if it keeps its distance from
    /// the facet's plane, m/s. Of facets that move as rigid bodies.
    double normal_velocity(const unsigned int facet, const Point<dim> &point) const
    {
      return facet_moves(facet)
               ? (start->signed_distance(facet, point) - end().signed_distance(facet, point)) / length
               : 0.;
    }

    /// Signed distance of a point, at @p point at the start of the step, from a facet's plane then.
    double distance_at_start(const unsigned int facet, const Point<dim> &point) const
    {
      return start->signed_distance(facet, point);
    }

    /// Facets that a particle's way from @p a to @p b passes through, each in the frame of its boundary; see
    /// Walls::crossed().
    std::vector<unsigned int> crossed(const Point<dim> &a, const Point<dim> &b, const double tolerance,
                                      const double rim) const;

    /// Put the particles of walls that move where they are at the end; @p old_position is where all particles were.
    void carry_particles(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const;

  private:
    /// Where a point that goes with a facet that deforms, at @p point at the start, is at the end.
    Point<dim> carried_by_facet(const unsigned int facet, const Point<dim> &point) const;

    const Walls<dim> *start;
    std::shared_ptr<const Walls<dim>> own_start; ///< what this points at, where there are facets of solids
    std::optional<Walls<dim>> moved;
    std::vector<std::optional<RigidMotion<dim>>> motions;
    double length        = 0.;
    unsigned int n_rigid = 0;
    double deformation   = 0.; ///< how far a corner of a solid's facet moves at most, m
  };
} // namespace Lahar

#endif
