// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_facet_geometry_h
#define lahar_geometry_facet_geometry_h

#include <deal.II/base/point.h>

#include <array>

namespace Lahar
{
  using namespace dealii;

  /// Normal of a facet, of any length; its side follows from the order of the corners.
  inline Tensor<1, 2> facet_normal(const std::array<Point<2>, 2> &corners)
  {
    return cross_product_2d(corners[1] - corners[0]);
  }

  inline Tensor<1, 3> facet_normal(const std::array<Point<3>, 3> &corners)
  {
    return cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
  }

  /// The normal of a facet with the length of its area (of its length in 2D), m² (m).
  template <int dim>
  inline Tensor<1, dim> area_vector(const std::array<Point<dim>, dim> &corners)
  {
    return facet_normal(corners) / (dim == 2 ? 1. : 2.);
  }

  /// The point of a facet (a segment in 2D, a triangle in 3D) nearest to @p point, by shares of its corners.
  std::array<double, 2> nearest_shares(const std::array<Point<2>, 2> &corners, const Point<2> &point);
  std::array<double, 3> nearest_shares(const std::array<Point<3>, 3> &corners, const Point<3> &point);

  /// The foot of @p point on the plane of a facet, by shares of its corners; beyond the facet some are negative.
  std::array<double, 2> foot_shares(const std::array<Point<2>, 2> &corners, const Point<2> &point);
  std::array<double, 3> foot_shares(const std::array<Point<3>, 3> &corners, const Point<3> &point);

  /// The point of a facet that has the given shares of its corners.
  template <int dim>
  inline Point<dim> point_of(const std::array<Point<dim>, dim> &corners,
                             const std::array<double, dim> &shares)
  {
    Point<dim> result;
    for (unsigned int v = 0; v < dim; ++v)
      result += shares[v] * Tensor<1, dim>(corners[v]);
    return result;
  }

  /// The point of a facet nearest to @p point.
  template <int dim>
  inline Point<dim> nearest_point(const std::array<Point<dim>, dim> &corners, const Point<dim> &point)
  {
    return point_of<dim>(corners, nearest_shares(corners, point));
  }
} // namespace Lahar

#endif
