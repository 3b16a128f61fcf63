// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/wall_step.h>
#include <lahar/geometry/facet_geometry.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  WallStep<dim>::WallStep(const Walls<dim> &walls, const Walls<dim> &end,
                          const std::vector<std::optional<RigidMotion<dim>>> &motions, const double length)
    : start(&walls)
    , moved(end)
    , motions(motions)
    , length(length)
    , n_rigid(walls.facets().size())
  {
    AssertDimension(walls.facets().size(), end.facets().size());
  }



  template <int dim>
  WallStep<dim> WallStep<dim>::with_solids(const std::vector<WallFacet<dim>> &at_start,
                                           const std::vector<WallFacet<dim>> &at_end,
                                           const double step_length) const
  {
    AssertDimension(at_start.size(), at_end.size());
    Assert(n_rigid == start->facets().size(), ExcMessage("There are solids already."));
    const auto append = [](const Walls<dim> &walls, const std::vector<WallFacet<dim>> &solids) {
      std::vector<WallFacet<dim>> facets = walls.facets();
      facets.insert(facets.end(), solids.begin(), solids.end());
      return Walls<dim>(facets, walls.boundary_names());
    };
    WallStep result(*this);
    result.own_start = std::make_shared<const Walls<dim>>(append(*start, at_start));
    result.start     = result.own_start.get();
    result.moved.emplace(append(end(), at_end));
    result.length = step_length;
    for (unsigned int f = 0; f < at_start.size(); ++f)
      for (unsigned int v = 0; v < dim; ++v)
        result.deformation = std::max(result.deformation,
                                      at_start[f].corners[v].distance(at_end[f].corners[v]));
    return result;
  }



  template <int dim>
  Point<dim> WallStep<dim>::carried_by_facet(const unsigned int facet, const Point<dim> &point) const
  {
    return point_of<dim>(end().facets()[facet].corners, foot_shares(start->facets()[facet].corners, point)) +
           start->signed_distance(facet, point) * end().normal(facet);
  }



  template <int dim>
  Tensor<1, dim> WallStep<dim>::facet_velocity_at_end(const unsigned int facet, const Point<dim> &point) const
  {
    if (!deforms(facet))
      return velocity_at_end(start->facets()[facet].boundary, point);
    const auto &corners = end().facets()[facet].corners;
    const auto shares   = foot_shares(corners, point);
    return (point_of<dim>(corners, shares) - point_of<dim>(start->facets()[facet].corners, shares)) / length;
  }



  template <int dim>
  std::vector<unsigned int> WallStep<dim>::crossed(const Point<dim> &a, const Point<dim> &b,
                                                   const double tolerance, const double rim) const
  {
    std::vector<unsigned int> found = end().crossed(a, b, tolerance, rim);
    if (!any_moves())
      return found;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const unsigned int facet) {
                                 return facet_moves(facet) || deforms(facet);
                               }),
                found.end());
    for (unsigned int boundary = 0; boundary < motions.size(); ++boundary)
      if (moves(boundary))
        for (const unsigned int facet : end().crossed(carried(boundary, a), b, tolerance, rim))
          if (end().facets()[facet].boundary == boundary)
            found.push_back(facet);
    if (end().facets().size() > n_rigid)
      for (const unsigned int facet : end().near(b, a.distance(b) + deformation + rim))
        if (deforms(facet) && end().is_crossed(facet, {carried_by_facet(facet, a), b}, tolerance, rim))
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
