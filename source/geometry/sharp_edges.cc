// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/sharp_edges.h>
#include <lahar/geometry/wall_shape.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// Whether an edge of a facet is sharp at one of its points.
    template <int dim>
    bool is_sharp(const unsigned int facet, const Point<dim> &point, const double tolerance,
                  const Walls<dim> &walls)
    {
      for (const unsigned int other : walls.near(point, tolerance))
        if (other != facet && std::abs(walls.signed_distance(other, point)) < tolerance &&
            walls.is_above(other, point, tolerance) &&
            (walls.is_above(other, point, -tolerance) ||
             std::abs(walls.normal(other) * walls.normal(facet)) > smooth_joint))
          return false;
      return true;
    }
  } // namespace



  template <int dim>
  std::vector<std::pair<Point<dim>, unsigned int>> points_on_sharp_edges(const Walls<dim> &walls,
                                                                         const MeshSize<dim> &h)
  {
    std::vector<std::pair<Point<dim>, unsigned int>> result;
    for (unsigned int f = 0; f < walls.facets().size(); ++f)
    {
      const WallFacet<dim> &facet = walls.facets()[f];
      if (!facet.sticks)
        continue;
      const auto add = [&](const Point<dim> &p) { result.emplace_back(p, facet.boundary); };
      for (unsigned int c = 0; c < dim; ++c)
      {
        const Point<dim> &a = facet.corners[c];
        const Point<dim> &b = facet.corners[(c + 1) % dim];
        if constexpr (dim == 2)
        {
          if (is_sharp(f, a, touching * h(a), walls))
            add(a);
        }
        else
        {
          // By pieces, seen at their middles: at their ends other edges meet.
          const double spacing        = h(a + 0.5 * (b - a));
          const unsigned int n_pieces = std::max(1., std::round(a.distance(b) / spacing));
          bool last                   = false;
          for (unsigned int k = 0; k < n_pieces; ++k)
          {
            const auto at    = [&](const double t) { return a + t / n_pieces * (b - a); };
            const bool sharp = is_sharp(f, at(k + 0.5), touching * spacing, walls);
            if (sharp && !last)
              add(at(k));
            if (sharp)
              add(at(k + 1));
            last = sharp;
          }
        }
      }
    }
    return result;
  }



  template std::vector<std::pair<Point<2>, unsigned int>> points_on_sharp_edges(const Walls<2> &,
                                                                                const MeshSize<2> &);
  template std::vector<std::pair<Point<3>, unsigned int>> points_on_sharp_edges(const Walls<3> &,
                                                                                const MeshSize<3> &);
} // namespace Lahar
