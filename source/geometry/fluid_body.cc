// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/wall_shape.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  double FluidBody<dim>::estimate_size(const double h) const
  {
    // Lattices of equilateral triangles and of body-centred cubes.
    double n         = dim == 2 ? 1.2 : 1.6;
    const Box<dim> b = box();
    for (unsigned int d = 0; d < dim; ++d)
      n *= (b.upper[d] - b.lower[d]) / h + 1.;
    return n;
  }



  template <int dim>
  Point<dim> FluidBody<dim>::onto_walls(Point<dim> p, const Walls<dim> &walls, const double h,
                                        const double reach) const
  {
    std::vector<unsigned int> facets = walls.near(p, reach);
    std::sort(facets.begin(), facets.end(), [&walls, p](const unsigned int f, const unsigned int g) {
      return std::abs(walls.signed_distance(f, p)) < std::abs(walls.signed_distance(g, p));
    });
    std::vector<std::pair<unsigned int, double>> sides;
    for (const unsigned int facet : facets)
      if (walls.facets()[facet].lands && std::abs(walls.signed_distance(facet, p)) < reach &&
          walls.is_above(facet, p, touching * h) && !walls.is_hidden(facet, p))
      {
        const Tensor<1, dim> aside = 0.25 * touching * h * walls.normal(facet);
        p -= walls.signed_distance(facet, p) * walls.normal(facet);
        sides.emplace_back(facet, signed_distance(p + aside) < signed_distance(p - aside) ? 1. : -1.);
        // In a corner that is no right angle the one wall moves it off the others.
        for (unsigned int round = 0; round < 2 * dim; ++round)
          for (const auto &[other, side] : sides)
            p += (side * contact_offset * h - walls.signed_distance(other, p)) * walls.normal(other);
      }
    return p;
  }



  template <int dim>
  Box<dim> box_around(const std::vector<Point<dim>> &points)
  {
    Box<dim> box(points.at(0), points.at(0));
    for (const Point<dim> &point : points)
      for (unsigned int d = 0; d < dim; ++d)
      {
        box.lower[d] = std::min(box.lower[d], point[d]);
        box.upper[d] = std::max(box.upper[d], point[d]);
      }
    return box;
  }



  template class FluidBody<2>;
  template class FluidBody<3>;
  template Box<2> box_around(const std::vector<Point<2>> &);
  template Box<3> box_around(const std::vector<Point<3>> &);
} // namespace Lahar
