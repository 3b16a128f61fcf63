// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_contact_sides_h
#define lahar_boundary_contact_sides_h

#include <lahar/boundary/wall_step.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * On which side of the facets around it one fluid particle is, in a step: 1 is that of the normal, −1 the other one.
   *
   * Where it is tells that only of a facet that it comes to through free space. A particle in contact is a hair off its
   * facet (contact_offset), while a surface of many facets bends by more at each joint: beyond a bulge it is behind the
   * plane of the next facet, and put onto one facet of a hollow joint it may be behind the other one. So the side goes on
   * from facet to facet: over a common edge (in the plane, a common end) always, whatever the angle there, by the order of
   * both facets' corners; over a common corner in space, or a bulge between facets that have no common corner, where the
   * surface is smooth (smooth_joint).
   */
  template <int dim>
  class ContactSides
  {
  public:
    /// @param step where the walls are and go to; it must outlive this object.
    explicit ContactSides(const WallStep<dim> &step)
      : step(step)
      , walls(step.end())
    {}

    /// The particle is, or was when the step began, in contact with a facet on that @p side.
    void add(const unsigned int facet, const int side);

    /// The side of facet @p to on which the particle is, if that is @p by_place for one that comes from nowhere.
    int find(const unsigned int to, const int by_place) const;

    /// Whether facet @p to goes on smoothly from facet @p from, which was added or may be none, for a particle on that
    /// @p side of @p to.
    bool goes_on(const int from, const unsigned int to, const int side) const;

    /// Whether facet @p to, which has an edge or corner in common with facet @p from, lies behind that: a particle on
    /// @p from, which was added or may be none, comes to it only round the edge.
    bool is_round_edge(const int from, const unsigned int to) const;

    /// The added facets that a particle leaves over a bulge when it comes to that @p side of facet @p to.
    std::vector<unsigned int> left_over_bulge(const unsigned int to, const int side) const;

    /// A facet less than @p reach (m) above the particle's @p place, which so is behind it, and the side to which the
    /// particle belongs: it was added, or goes on from one that was. What lies round an edge of one of the facets
    /// @p in_contact (ParticleCloud::contact_facets) is none.
    std::optional<std::pair<unsigned int, int>> passed_by(const Point<dim> &place, const double reach,
                                                          const std::array<int, dim> &in_contact) const;

  private:
    /// The side of facet @p to that goes on from those of the facets that were added, over an edge or a corner; else 0.
    int passed_on(const unsigned int to) const;

    /// The side on which the particle is or was of a facet that was added; 0 of others and of none.
    int added_side(const int facet) const;

    /// Whether the middle of facet @p to lies behind @p from, for a particle on that @p side of it.
    bool is_behind(const unsigned int from, const int side, const unsigned int to) const;

    const WallStep<dim> &step;
    const Walls<dim> &walls; ///< at the end of the step
    std::vector<std::pair<unsigned int, int>> added;
  };
} // namespace Lahar

#endif
