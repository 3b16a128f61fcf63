// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/initial_region.h>

#include <limits>

namespace Lahar
{
  template <int dim>
  InitialRegion<dim>::InitialRegion(const std::vector<std::unique_ptr<FluidBody<dim>>> &bodies)
  {
    for (const auto &body : bodies)
    {
      this->bodies.push_back(body.get());
      boxes.push_back(body->box());
    }
  }



  template <int dim>
  double InitialRegion<dim>::volume() const
  {
    double sum = 0.;
    for (const FluidBody<dim> *body : bodies)
      sum += body->volume();
    return sum;
  }



  template <int dim>
  double InitialRegion<dim>::signed_distance(const Point<dim> &point) const
  {
    double smallest = std::numeric_limits<double>::max();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (smallest == std::numeric_limits<double>::max() || boxes[b].contains(point, std::max(smallest, 0.)))
        smallest = std::min(smallest, bodies[b]->signed_distance(point));
    return smallest;
  }



  template <int dim>
  bool InitialRegion<dim>::holds(const Point<dim> &a, const Point<dim> &b, const double tolerance,
                                 const double resolution) const
  {
    // The distance changes by at most the way to the ends.
    const Point<dim> middle = a + 0.5 * (b - a);
    const double distance = signed_distance(middle), half = 0.5 * a.distance(b);
    if (distance > tolerance)
      return false;
    return distance + half <= tolerance || half < resolution ||
           (holds(a, middle, tolerance, resolution) && holds(middle, b, tolerance, resolution));
  }



  template <int dim>
  bool InitialRegion<dim>::holds(const SimplexCorners<dim> &corners, const double tolerance,
                                 const double resolution) const
  {
    const Point<dim> centre = centroid<dim>(corners);
    const double distance   = signed_distance(centre);
    if (distance > tolerance)
      return false;
    double radius = 0.;
    for (const Point<dim> &corner : corners)
      radius = std::max(radius, corner.distance(centre));
    if (distance + radius <= tolerance)
      return true;

    if (dim == 3)
      for (const Point<dim> &opposite : corners)
        if (signed_distance(centre + (centre - opposite) / double(dim)) > tolerance)
          return false;
    for (unsigned int a = 0; a <= dim; ++a)
      for (unsigned int b = 0; b < a; ++b)
        if (!holds(corners[a], corners[b], tolerance, resolution))
          return false;
    return true;
  }



  template class InitialRegion<2>;
  template class InitialRegion<3>;
} // namespace Lahar
