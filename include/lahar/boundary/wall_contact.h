// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_wall_contact_h
#define lahar_boundary_wall_contact_h

#include <lahar/boundary/contact_sides.h>
#include <lahar/boundary/wall_separation.h>
#include <lahar/boundary/wall_step.h>
#include <lahar/linear/node_constraint.h>
#include <lahar/particles/particle_cloud.h>

#include <functional>
#include <vector>

namespace Lahar
{
  /**
   * Contact with walls and the slick surfaces of solids: which particles lie on them, and what that prescribes: n·v is
   * that of the wall, and where the fluid sticks to it all of v. What resists sliding is no matter of this class, see
   * SlidingContact.
   *
   * A particle that passes through a facet on which fluid lands (WallFacet), or comes nearer than a tenth of its spacing, is
   * put on it and takes its normal velocity. It lies contact_offset times its spacing off the facet's plane, on its side,
   * and stays there wherever the plane goes. Where a surface is smooth (smooth_joint) it goes on from one facet to the next,
   * over a bulge too, where it comes from behind the next facet's plane (ContactSides); in a sharp hollow corner it belongs
   * to two or three, and near the edge of a body to both faces if it sticks to them; where it slides it flows over the edge.
   * It leaves a facet over its rim, when it is isolated, or where the facet separates (WallSeparation); what moves away from
   * such a facet does not land on it for being near, unless it comes along it from one that goes on smoothly into it.
   */
  template <int dim>
  class WallContact
  {
  public:
    /// @param step where the walls are and go to; it must outlive this object.
    explicit WallContact(const WallStep<dim> &step, const TensileStrengths &strengths = {})
      : step(step)
      , walls(step.end())
      , strengths(strengths)
    {}

    /// Put all fluid particles that lie on a wall in contact with it.
    void initialize(ParticleCloud<dim> &cloud) const;

    /// Contact and separation after the step, which moved the particles away from @p old_position (by particle). What
    /// @p flies, by particle, or none, falls freely: it is in contact with what it meets only.
    void update(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud,
                const std::vector<bool> &flies = {}) const;

    /// The prescribed components of a particle's mean velocity in the step that begins: all of particles of walls and solids
    /// and of those that stick, the normal ones of those that slide along walls. What solids ask for is not prescribed, see
    /// SolidTouch.
    NodeConstraint<dim> constraint(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

  private:
    /// A facet to which the particle sticks, ParticleCloud::no_facet if there is none.
    int sticking_facet(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

    /// Put a particle in contact with a facet, on that @p side of it (1: that of the normal, or −1).
    void attach(const unsigned int particle, const unsigned int facet, const int side,
                ParticleCloud<dim> &cloud) const;

    /// Put a fluid particle in contact with all facets nearer than @p distance (m) that it sees, on the side where it is, and
    /// add them to its @p sides. What separates counts if @p meets says so of facet and side.
    void attach_near(const unsigned int particle, const double distance,
                     const std::function<bool(const unsigned int, const int)> &meets,
                     ContactSides<dim> &sides, ParticleCloud<dim> &cloud) const;

    /// Put a particle back on its facets where some are those of solids: the velocities are within the tolerance of the
    /// nonlinear iteration, which may be more than the particle is off a facet.
    void put_on_solids(const unsigned int particle, const Point<dim> &old_position,
                       ParticleCloud<dim> &cloud) const;

    /// Whether fluid leaves a facet where it pulls.
    bool separates(const unsigned int facet) const;

    /// On which side of a facet a point is at the end of the step; of one of a solid, outside.
    int side_of(const unsigned int facet, const Point<dim> &point) const;
    /// The same at the start of the step.
    int side_at_start(const unsigned int facet, const Point<dim> &point) const;

    /// What the slip facets of a particle prescribe, those of solids with them or not, if the wanted component along a
    /// facet's normal is @p speed (m/s).
    NodeConstraint<dim> sliding(const unsigned int particle, const ParticleCloud<dim> &cloud,
                                const std::function<double(const unsigned int)> &speed,
                                const bool with_solids) const;
    /// The same with the facets' own velocities at the end of the step, where the particle is.
    NodeConstraint<dim> sliding_at_end(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

    const WallStep<dim> &step;
    const Walls<dim> &walls; ///< at the end of the step
    TensileStrengths strengths;
  };
} // namespace Lahar

#endif
