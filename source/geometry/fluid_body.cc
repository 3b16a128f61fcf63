// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>

#include <algorithm>
#include <limits>

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
  MeshBody<dim>::MeshBody(const std::string &name, const std::vector<Point<dim>> &nodes)
    : FluidBody<dim>(name)
    , nodes(nodes)
  {}



  template <int dim>
  Box<dim> MeshBody<dim>::box() const
  {
    return box_around(nodes);
  }



  template <int dim>
  double MeshBody<dim>::signed_distance(const Point<dim> &) const
  {
    return std::numeric_limits<double>::infinity();
  }



  template <int dim>
  double MeshBody<dim>::estimate_size(const double) const
  {
    return nodes.size();
  }



  template <int dim>
  std::vector<Point<dim>> MeshBody<dim>::fill(const MeshSize<dim> &) const
  {
    return nodes;
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
  template class MeshBody<2>;
  template class MeshBody<3>;
  template Box<2> box_around(const std::vector<Point<2>> &);
  template Box<3> box_around(const std::vector<Point<3>> &);
} // namespace Lahar
