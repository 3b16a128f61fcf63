// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_simplex_geometry_h
#define lahar_geometry_simplex_geometry_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <lahar/geometry/delaunay.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Lahar
{
  template <int dim>
  using SimplexCorners = std::array<Point<dim>, dim + 1>;

  /// The corners of a simplex.
  template <int dim>
  inline SimplexCorners<dim> corners_of(const Simplex<dim> &simplex, const std::vector<Point<dim>> &points)
  {
    SimplexCorners<dim> corners;
    for (unsigned int c = 0; c <= dim; ++c)
      corners[c] = points[simplex[c]];
    return corners;
  }

  /// The edges from corner 0 to the others, one a row.
  template <int dim>
  inline Tensor<2, dim> edge_matrix(const SimplexCorners<dim> &x)
  {
    Tensor<2, dim> edges;
    for (unsigned int c = 0; c < dim; ++c)
      edges[c] = x[c + 1] - x[0];
    return edges;
  }

  /// Signed volume (area in 2D), positive for positively oriented corners.
  template <int dim>
  inline double signed_volume(const SimplexCorners<dim> &x)
  {
    return determinant(edge_matrix<dim>(x)) / (dim == 2 ? 2. : 6.);
  }

  template <int dim>
  inline Point<dim> centroid(const SimplexCorners<dim> &x)
  {
    Point<dim> mean;
    for (const Point<dim> &corner : x)
      mean += corner / (dim + 1.);
    return mean;
  }

  /// The vector from corner 0 to the centre of the sphere through the corners; infinite for a simplex without volume.
  template <int dim>
  inline Tensor<1, dim> to_circumcentre(const SimplexCorners<dim> &x)
  {
    // The centre c satisfies 2 (x_i − x_0)·(c − x_0) = |x_i − x_0|².
    const Tensor<2, dim> edges = edge_matrix<dim>(x);
    Tensor<1, dim> right_hand_side;
    if (std::abs(determinant(edges)) < std::numeric_limits<double>::min())
    {
      right_hand_side[0] = std::numeric_limits<double>::infinity();
      return right_hand_side;
    }
    for (unsigned int c = 0; c < dim; ++c)
      right_hand_side[c] = 0.5 * edges[c].norm_square();
    return invert(edges) * right_hand_side;
  }

  /// Radius of the sphere through the corners; infinite for a simplex without volume.
  template <int dim>
  inline double circumradius(const SimplexCorners<dim> &x)
  {
    return to_circumcentre<dim>(x).norm();
  }

  /// Gradients of the linear shape functions; the simplex must have volume.
  template <int dim>
  inline std::array<Tensor<1, dim>, dim + 1> shape_gradients(const SimplexCorners<dim> &x)
  {
    const Tensor<2, dim> inverse = invert(edge_matrix<dim>(x));
    std::array<Tensor<1, dim>, dim + 1> gradients;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
      {
        gradients[c + 1][d] = inverse[d][c];
        gradients[0][d] -= inverse[d][c];
      }
    return gradients;
  }
} // namespace Lahar

#endif
