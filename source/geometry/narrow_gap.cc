// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/narrow_gap.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    constexpr double closed = 0.1;   // over h
    constexpr double facing = 0.866; // cosine of the angle between normals

    /// A facet is looked at in this many places along an edge at most.
    constexpr double max_places = 100.;

    /// Over the width of a gap.
    constexpr double pocket        = 10.;
    constexpr unsigned int n_looks = 8;

    /// Whether walls stand all round @p place along the gap of this @p width whose walls are normal to @p direction.
    bool is_enclosed(const Walls<3> &walls, const Point<3> &place, const Tensor<1, 3> &direction,
                     const double width)
    {
      unsigned int least = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(direction[d]) < std::abs(direction[least]))
          least = d;
      Tensor<1, 3> axis;
      axis[least]               = 1.;
      Tensor<1, 3> first        = cross_product_3d(direction, axis);
      first                     = first / first.norm();
      const Tensor<1, 3> second = cross_product_3d(direction, first);
      for (unsigned int k = 0; k < n_looks; ++k)
      {
        // Not along the axes, in which edges of facets often lie.
        const double angle     = (k + 0.31) * 2. * numbers::PI / n_looks;
        const Tensor<1, 3> way = pocket * width * (std::cos(angle) * first + std::sin(angle) * second);
        if (walls.crossed(place, place + way, 0., 0.).empty())
          return false;
      }
      return true;
    }

    /// In the plane bodies are closed lines.
    bool is_enclosed(const Walls<2> &, const Point<2> &, const Tensor<1, 2> &, const double)
    {
      return false;
    }

    /// Points of a segment, less than h apart where that are not too many.
    std::vector<Point<2>> places_on(const std::array<Point<2>, 2> &corners, const double h)
    {
      const unsigned int n = std::ceil(std::min(corners[0].distance(corners[1]) / h + 1., max_places));
      std::vector<Point<2>> result;
      for (unsigned int i = 0; i < n; ++i)
        result.push_back(corners[0] + (i + 0.5) / n * (corners[1] - corners[0]));
      return result;
    }

    std::vector<Point<3>> places_on(const std::array<Point<3>, 3> &corners, const double h)
    {
      const auto &[a, b, c] = corners;
      const double longest  = std::max({a.distance(b), b.distance(c), c.distance(a)});
      const unsigned int n  = std::ceil(std::min(longest / h + 1., max_places));
      std::vector<Point<3>> result;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; i + j < n; ++j)
          result.push_back(a + (i + 1. / 3.) / n * (b - a) + (j + 1. / 3.) / n * (c - a));
      return result;
    }
  } // namespace



  template <int dim>
  std::optional<NarrowGap<dim>> NarrowGap<dim>::find(const std::vector<WallFacet<dim>> &facets,
                                                     const std::vector<std::string> &owners,
                                                     const std::function<bool(const Point<dim> &)> &is_filled,
                                                     const MeshSize<dim> &h, const double most)
  {
    const Walls<dim> walls(facets);
    std::optional<NarrowGap> narrowest;
    for (unsigned int f = 0; f < facets.size(); ++f)
      for (const Point<dim> &p : places_on(facets[f].corners, h.coarsest()))
        for (const double side : {-1., 1.})
        {
          const Tensor<1, dim> direction = side * walls.normal(f);
          const double reach             = (narrowest ? narrowest->ratio : most * (1. - 1e-6)) * h(p);
          for (const unsigned int other :
               walls.crossed(p + 1e-3 * h(p) * direction, p + reach * direction, 0., 0.))
          {
            const double cosine = direction * walls.normal(other);
            const double width  = std::abs(walls.signed_distance(other, p) / cosine);
            if (owners[other] != owners[f] && std::abs(cosine) > facing && width > closed * h(p) &&
                (!narrowest || width < narrowest->ratio * h(p)) && !is_filled(p + 0.5 * width * direction) &&
                !is_enclosed(walls, p + 0.5 * width * direction, direction, width))
              narrowest = NarrowGap{width, width / h(p), p + 0.5 * width * direction, owners[f],
                                    owners[other]};
          }
        }
    return narrowest;
  }



  template struct NarrowGap<2>;
  template struct NarrowGap<3>;
} // namespace Lahar
