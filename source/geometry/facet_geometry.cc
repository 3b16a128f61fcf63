// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>

#include <algorithm>
#include <limits>

namespace Lahar
{
  std::array<double, 2> foot_shares(const std::array<Point<2>, 2> &corners, const Point<2> &point)
  {
    const Tensor<1, 2> edge = corners[1] - corners[0];
    const double share      = edge * (point - corners[0]) / edge.norm_square();
    return {{1. - share, share}};
  }



  std::array<double, 3> foot_shares(const std::array<Point<3>, 3> &corners, const Point<3> &point)
  {
    const Tensor<1, 3> normal = cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
    std::array<double, 3> shares;
    for (unsigned int v = 0; v < 3; ++v)
    {
      const Point<3> &b = corners[(v + 1) % 3], &c = corners[(v + 2) % 3];
      shares[v] = normal * cross_product_3d(c - b, point - b) / normal.norm_square();
    }
    return shares;
  }



  std::array<double, 2> nearest_shares(const std::array<Point<2>, 2> &corners, const Point<2> &point)
  {
    const double share = std::min(1., std::max(0., foot_shares(corners, point)[1]));
    return {{1. - share, share}};
  }



  std::array<double, 3> nearest_shares(const std::array<Point<3>, 3> &corners, const Point<3> &point)
  {
    std::array<double, 3> shares = foot_shares(corners, point);
    if (std::all_of(shares.begin(), shares.end(), [](const double share) { return share >= 0.; }))
      return shares;
    double nearest = std::numeric_limits<double>::max();
    for (unsigned int v = 0; v < 3; ++v)
    {
      const Point<3> &a = corners[v], &b = corners[(v + 1) % 3];
      const double along  = std::min(1., std::max(0., (b - a) * (point - a) / (b - a).norm_square()));
      const double square = (a + along * (b - a)).distance_square(point);
      if (square < nearest)
      {
        nearest             = square;
        shares              = {};
        shares[v]           = 1. - along;
        shares[(v + 1) % 3] = along;
      }
    }
    return shares;
  }
} // namespace Lahar
