// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/initial/initial_geometry.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  bool InitialGeometry<dim>::any_boundary_moves() const
  {
    return std::any_of(boundaries.begin(), boundaries.end(),
                       [](const Boundary<dim> &boundary) { return boundary.motion->moves(); });
  }



  template <int dim>
  Walls<dim> InitialGeometry<dim>::walls_at(const double time) const
  {
    std::vector<RigidMotion<dim>> motions;
    std::vector<std::string> names;
    for (const Boundary<dim> &boundary : boundaries)
    {
      motions.push_back(boundary.motion->at(time));
      names.push_back(boundary.name);
    }
    std::vector<WallFacet<dim>> facets;
    for (const WallShape<dim> &wall : wall_shapes)
      for (WallFacet<dim> facet : wall.facets())
      {
        if (facet.moves)
          for (Point<dim> &corner : facet.corners)
            corner = motions[facet.boundary](corner);
        facets.push_back(facet);
      }
    return Walls<dim>(facets, names);
  }



  template <int dim>
  WallStep<dim> InitialGeometry<dim>::wall_step(const Walls<dim> &walls, const double time,
                                                const double time_step) const
  {
    if (!any_boundary_moves())
      return WallStep<dim>(walls);
    std::vector<std::optional<RigidMotion<dim>>> motions;
    for (const Boundary<dim> &boundary : boundaries)
    {
      motions.emplace_back();
      if (boundary.motion->moves())
        motions.back() = boundary.motion->at(time + time_step).after(boundary.motion->at(time).inverse());
    }
    return WallStep<dim>(walls, walls_at(time + time_step), motions, time_step);
  }



  template bool InitialGeometry<2>::any_boundary_moves() const;
  template bool InitialGeometry<3>::any_boundary_moves() const;
  template Walls<2> InitialGeometry<2>::walls_at(const double) const;
  template Walls<3> InitialGeometry<3>::walls_at(const double) const;
  template WallStep<2> InitialGeometry<2>::wall_step(const Walls<2> &, const double, const double) const;
  template WallStep<3> InitialGeometry<3>::wall_step(const Walls<3> &, const double, const double) const;
} // namespace Lahar
