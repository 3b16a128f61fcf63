// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_slip_condition_h
#define lahar_boundary_slip_condition_h

#include <lahar/geometry/walls.h>
#include <lahar/linear/node_constraint.h>
#include <lahar/particles/particle_cloud.h>

#include <vector>

namespace Lahar
{
  /**
   * Free slip along walls: n·v = 0 for the particles that touch a slip wall, no shear traction.
   *
   * A particle that passes through a slip facet, or comes nearer than a tenth of its spacing, is put on the facet and
   * loses its normal velocity; from then on it slides. Where two facets meet in a hollow corner it belongs to both. It
   * leaves a facet only over its rim or when it is isolated.
   */
  template <int dim>
  class SlipCondition
  {
  public:
    explicit SlipCondition(const Walls<dim> &walls)
      : walls(walls)
    {}

    /// Put all fluid particles that lie on a slip wall in contact with it.
    void initialize(ParticleCloud<dim> &cloud) const;

    /// Contact and separation after a step that moved the particles away from @p old_position (by particle).
    void update(const std::vector<Point<dim>> &old_position, ParticleCloud<dim> &cloud) const;

    /// Separate a particle from all slip walls.
    static void release(const unsigned int particle, ParticleCloud<dim> &cloud);

    /// The prescribed components of a particle's velocity: all at a wall or solid, the normal ones at slip walls.
    NodeConstraint<dim> constraint(const unsigned int particle, const ParticleCloud<dim> &cloud) const;

  private:
    void attach(const unsigned int particle, const unsigned int facet, ParticleCloud<dim> &cloud) const;

    const Walls<dim> &walls;
  };
} // namespace Lahar

#endif
