#include <lahar/geometry/cone_body.h>
#include <lahar/geometry/lattice.h>
#include <lahar/geometry/polygon.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  ConeBody::ConeBody(const std::string &name, const Point<3> &base, const double base_radius,
                     const double top_radius, const double height)
    : FluidBody<3>(name)
    , base(base)
    , base_radius(base_radius)
    , top_radius(top_radius)
    , height(height)
  {}



  Box<3> ConeBody::box() const
  {
    const double r = std::max(base_radius, top_radius);
    return {base - Tensor<1, 3>({r, r, 0.}), base + Tensor<1, 3>({r, r, height})};
  }



  double ConeBody::signed_distance(const Point<3> &point) const
  {
    const Tensor<1, 3> x = point - base;
    const double slope   = (top_radius - base_radius) / height; // dr/dz of the side
    const double side = (std::hypot(x[0], x[1]) - base_radius - slope * x[2]) / std::sqrt(1. + slope * slope);
    return std::max({side, -x[2], x[2] - height});
  }



  std::vector<Point<3>> ConeBody::fill(const double h) const
  {
    std::vector<Point<3>> contour;
    const double slant        = std::hypot(base_radius - top_radius, height);
    const unsigned int n_rows = std::max(1., std::round(slant / (std::sqrt(0.75) * h)));
    for (unsigned int row = 0; row <= n_rows; ++row)
    {
      const double share = double(row) / n_rows, r = base_radius + share * (top_radius - base_radius);
      const unsigned int n = std::max(3., std::round(2. * numbers::PI * r / h));
      Polygon ring;
      for (unsigned int i = 0; i < n; ++i)
      {
        const double angle = 2. * numbers::PI * (i + (row % 2) * 0.5) / n;
        ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
      }
      // The base and the top are discs; all points of the ring are corners, which filling keeps.
      for (const Point<2> &p : row == 0 || row == n_rows ? fill_polygon(ring, h) : ring)
        contour.push_back(base + Tensor<1, 3>({p[0], p[1], share * height}));
    }
    return fill_inside(*this, contour, h);
  }
} // namespace Lahar
