// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/wall_step.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  WallStep<dim>::WallStep(const Walls<dim> &walls, const Walls<dim> &end,
                          const std::vector<std::optional<RigidMotion<dim>>> &motions, const double length)
    : start(walls)
    , moved(end)
    , motions(motions)
    , length(length)
  {
    AssertDimension(walls.facets().size(), end.facets().size());
  }



  template <int dim>
  std::vector<unsigned int> WallStep<dim>::crossed(const Point<dim> &a, const Point<dim> &b,
                                                   const double tolerance, const double rim) const
  {
    std::vector<unsigned int> found = end().crossed(a, b, tolerance, rim);
    if (!any_moves())
      return found;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const unsigned int facet) { return facet_moves(facet); }),
                found.end());
    for (unsigned int boundary = 0; boundary < motions.size(); ++boundary)
      if (moves(boundary))
        for (const unsigned int facet : end().crossed(carried(boundary, a), b, tolerance, rim))
          if (end().facets()[facet].boundary == boundary)
            found.push_back(facet);
    std::sort(found.begin(), found.end());
    return found;
  }



  template <int dim>
  void WallStep<dim>::carry_particles(const std::vector<Point<dim>> &old_position,
                                      ParticleCloud<dim> &cloud) const
  {
    if (!any_moves())
      return;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.kind[i] == ParticleKind::wall && moves(cloud.part[i]))
      {
        cloud.position[i] = carried(cloud.part[i], old_position[i]);
        cloud.velocity[i] = velocity(cloud.part[i], old_position[i]);
      }
  }



  template class WallStep<2>;
  template class WallStep<3>;
} // namespace Lahar
