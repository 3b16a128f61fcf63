// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_slip_condition_h
#define lahar_boundary_slip_condition_h

#include <lahar/boundary/wall_step.h>
#include <lahar/linear/node_constraint.h>
#include <lahar/particles/particle_cloud.h>

#include <functional>
#include <vector>

namespace Lahar
{
  /**
   * Sliding along walls: n·v is that of the wall for the particles that touch a slip wall. What resists their sliding is
   * no matter of this class, see SlidingContact.
   *
   * A particle that passes through a slip facet, or comes nearer than a tenth of its spacing, is put on the facet and
   * takes its normal velocity; from then on it slides, and stays in the facet's plane wherever that goes. Where two
   * facets meet in a hollow corner it belongs to both. It leaves a facet only over its rim or when it is isolated.
   */
  template <int dim>
  class SlipCondition
  {
  public:
    /// @param step where the walls are and go to; it must outlive this object.
    explicit SlipCondition(const WallStep<dim> &step)
      : step(step)
      , walls(step.end())
    {}

    /// Put all fluid particles that lie on a slip wall in contact with it.
    void initialize(ParticleCloud<dim> &cloud) const;

    /// Contact and separation after the step, which moved the particles away from @p old_position (by particle).
    void update(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const;

    /// Separate a particle from all slip walls.
    static void release(const unsigned int particle, ParticleCloud<dim> &cloud);

    /// The prescribed components of a particle's mean velocity in the step that begins: all at a wall or solid, the
    /// normal ones at slip walls.
    NodeConstraint<dim> constraint(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

  private:
    /// A facet to which the particle sticks, ParticleCloud::no_facet if there is none.
    int sticking_facet(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

    /// Put a particle in contact with a facet, on that @p side of it (1: that of the normal, or −1).
    void attach(const unsigned int particle, const unsigned int facet, const int side,
                ParticleCloud<dim> &cloud) const;

    /// On which side of a facet a point is at the end of the step.
    int side_of(const unsigned int facet, const Point<dim> &point) const;

    /// What the slip facets of a particle prescribe, if the wanted component along a facet's normal is @p speed (m/s).
    NodeConstraint<dim> sliding(const unsigned int particle, const ParticleCloud<dim> &cloud,
                                const std::function<double(const unsigned int)> &speed) const;
    /// The same with the facets' own velocities at the end of the step, where the particle is.
    NodeConstraint<dim> sliding_at_end(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

    const WallStep<dim> &step;
    const Walls<dim> &walls; ///< at the end of the step
  };
} // namespace Lahar

#endif
