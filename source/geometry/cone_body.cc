// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/cone_body.h>
#include <lahar/geometry/lattice.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/polygon.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  ConeBody::ConeBody(const std::string &name, const Point<3> &base, const Point<3> &top,
                     const double base_radius, const double top_radius)
    : FluidBody<3>(name)
    , base(base)
    , top(top)
    , base_radius(base_radius)
    , top_radius(top_radius)
    , height(base.distance(top))
  {
    axes[2]               = (top - base) / height;
    unsigned int steepest = 0; // of the coordinate directions, to the axis
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(axes[2][d]) < std::abs(axes[2][steepest]))
        steepest = d;
    axes[0][steepest] = 1.;
    axes[0] -= axes[2][steepest] * axes[2];
    axes[0] /= axes[0].norm();
    axes[1] = cross_product_3d(axes[2], axes[0]);
  }



  Box<3> ConeBody::box() const
  {
    std::vector<Point<3>> extremes;
    for (const auto &[centre, radius] : {std::make_pair(base, base_radius), std::make_pair(top, top_radius)})
      for (unsigned int d = 0; d < 3; ++d)
        for (const double sign : {-1., 1.})
        {
          extremes.push_back(centre);
          extremes.back()[d] += sign * radius * std::hypot(axes[0][d], axes[1][d]);
        }
    return box_around(extremes);
  }



  double ConeBody::volume() const
  {
    return numbers::PI / 3. * height *
           (base_radius * base_radius + base_radius * top_radius + top_radius * top_radius);
  }



  double ConeBody::signed_distance(const Point<3> &point) const
  {
    const Tensor<1, 3> x = point - base;
    const double z       = axes[2] * x;
    const double slope   = (top_radius - base_radius) / height; // dr/dz of the side
    const double side    = (std::hypot(axes[0] * x, axes[1] * x) - base_radius - slope * z) /
                        std::sqrt(1. + slope * slope);
    return std::max({side, -z, z - height});
  }



  DividedPoints<3> ConeBody::fill(const MeshSize<3> &h, const MPI_Comm &communicator) const
  {
    std::vector<Point<3>> contour;
    PointSet<3> places;
    const double finest       = h.finest_in(box());
    const double slant        = std::hypot(base_radius - top_radius, height);
    const unsigned int n_rows = std::max(1., std::round(slant / (std::sqrt(0.75) * finest)));
    for (unsigned int row = 0; row <= n_rows; ++row)
    {
      const double share = double(row) / n_rows, r = base_radius + share * (top_radius - base_radius);
      const unsigned int n = std::max(3., std::round(2. * numbers::PI * r / finest));
      Polygon ring;
      for (unsigned int i = 0; i < n; ++i)
      {
        const double angle = 2. * numbers::PI * (i + (row % 2) * 0.5) / n;
        ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
      }
      const auto in_space = [&](const Point<2> &p) {
        return base + p[0] * axes[0] + p[1] * axes[1] + share * height * axes[2];
      };
      const bool is_disc = row == 0 || row == n_rows;
      if (!h.is_uniform()) // the rings are those of the smallest size: thin them
      {
        Polygon thin;
        for (const Point<2> &p : ring)
          if (places.insert_if_free(in_space(p), 0.75 * h(in_space(p))))
            thin.push_back(p);
        if (!is_disc || thin.size() >= 3)
          ring = thin;
      }
      // The base and the top are discs; all points of the ring are corners, which filling keeps.
      if (is_disc)
        ring = all_points(fill_polygon(
                            ring, [&](const Point<2> &p) { return h(in_space(p)); }, h.levels(),
                            communicator),
                          communicator);
      for (const Point<2> &p : ring)
        contour.push_back(in_space(p));
    }
    return fill_inside(*this, contour, h, communicator);
  }
} // namespace Lahar
