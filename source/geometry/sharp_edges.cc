// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/point_set.h>
#include <lahar/geometry/sharp_edges.h>
#include <lahar/geometry/wall_shape.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// The direction from a point of an edge into a facet, at right angles to the edge; @p along has unit length, in the
    /// plane it is zero.
    template <int dim>
    Tensor<1, dim> inwards(const WallFacet<dim> &facet, const Point<dim> &point, const Tensor<1, dim> &along)
    {
      Tensor<1, dim> direction;
      for (const Point<dim> &corner : facet.corners)
        direction += (corner - point) / dim;
      direction -= (direction * along) * along;
      return direction / direction.norm();
    }

    /// Whether an edge of a facet is sharp at one of its points: no facet goes on from it, none has it in its middle.
    template <int dim>
    bool is_sharp(const unsigned int facet, const Point<dim> &point, const Tensor<1, dim> &along,
                  const double tolerance, const Walls<dim> &walls)
    {
      const Tensor<1, dim> direction = inwards<dim>(walls.facets()[facet], point, along);
      for (const unsigned int other : walls.near(point, tolerance))
        if (other != facet && std::abs(walls.signed_distance(other, point)) < tolerance &&
            walls.is_above(other, point, tolerance) &&
            (walls.is_above(other, point, -tolerance) ||
             direction * inwards<dim>(walls.facets()[other], point, along) < -smooth_joint))
          return false;
      return true;
    }
  } // namespace



  template <int dim>
  std::vector<std::pair<Point<dim>, unsigned int>> points_on_sharp_edges(const Walls<dim> &walls,
                                                                         const MeshSize<dim> &h)
  {
    std::vector<std::pair<Point<dim>, unsigned int>> result;
    PointSet<dim> places;
    for (unsigned int f = 0; f < walls.facets().size(); ++f)
    {
      const WallFacet<dim> &facet = walls.facets()[f];
      if (!facet.sticks)
        continue;
      const auto add = [&](const Point<dim> &p) {
        if (places.insert_if_free(p, 0.5 * h(p)))
          result.emplace_back(p, facet.boundary);
      };
      for (unsigned int c = 0; c < dim; ++c)
      {
        const Point<dim> &a = facet.corners[c];
        const Point<dim> &b = facet.corners[(c + 1) % dim];
        if constexpr (dim == 2)
        {
          if (is_sharp(f, a, Tensor<1, dim>(), touching * h(a), walls))
            add(a);
        }
        else
        {
          // By pieces, seen at their middles: at their ends other edges meet.
          const double spacing        = std::min({h(a), h(a + 0.5 * (b - a)), h(b)});
          const Tensor<1, dim> along  = (b - a) / a.distance(b);
          const unsigned int n_pieces = std::max(1., std::round(a.distance(b) / spacing));
          bool last                   = false;
          for (unsigned int k = 0; k < n_pieces; ++k)
          {
            const auto at    = [&](const double t) { return a + t / n_pieces * (b - a); };
            const bool sharp = is_sharp(f, at(k + 0.5), along, touching * spacing, walls);
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
