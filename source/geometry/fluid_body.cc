// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>

#include <algorithm>

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
