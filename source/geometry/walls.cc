// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>
#include <lahar/geometry/walls.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  Walls<dim>::Walls(const std::vector<WallFacet<dim>> &facets, const std::vector<std::string> &names)
    : all_facets(facets)
    , names(names)
  {
    std::vector<Box> boxes;
    for (unsigned int f = 0; f < facets.size(); ++f)
    {
      const Tensor<1, dim> normal = facet_normal(facets[f].corners);
      normals.push_back(normal / normal.norm());
      boxes.emplace_back(BoundingBox<dim>(facets[f].corners), f);
    }
    tree = pack_rtree(boxes);
  }



  template <int dim>
  double Walls<dim>::signed_distance(const unsigned int facet, const Point<dim> &point) const
  {
    return normals[facet] * (point - all_facets[facet].corners[0]);
  }



  template <int dim>
  bool Walls<dim>::is_above(const unsigned int facet, const Point<dim> &point, const double tolerance) const
  {
    // The foot lies inside if it is on the inner side of every rim: of the two ends in 2D, of the three edges in 3D.
    const auto &corners = all_facets[facet].corners;
    for (unsigned int c = 0; c < dim; ++c)
    {
      const Tensor<1, dim> along = corners[(c + 1) % dim] - corners[c];
      Tensor<1, dim> inward;
      if constexpr (dim == 2)
        inward = along;
      else
        inward = cross_product_3d(normals[facet], along);
      if (inward / inward.norm() * (point - corners[c]) < -tolerance)
        return false;
    }
    return true;
  }



  template <int dim>
  std::vector<unsigned int> Walls<dim>::near(const Point<dim> &point, const double distance) const
  {
    Point<dim> lower = point, upper = point;
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] -= distance;
      upper[d] += distance;
    }
    std::vector<unsigned int> found;
    for (const auto &entry : tree | boost::geometry::index::adaptors::queried(
                                      boost::geometry::index::intersects(BoundingBox<dim>({lower, upper}))))
      found.push_back(entry.second);
    std::sort(found.begin(), found.end());
    return found;
  }



  template <int dim>
  std::vector<unsigned int> Walls<dim>::crossed(const Point<dim> &a, const Point<dim> &b,
                                                const double tolerance, const double rim) const
  {
    BoundingBox<dim> box(std::array<Point<dim>, 2>{{a, b}});
    box.extend(std::max(rim, 0.));
    std::vector<unsigned int> found;
    for (const auto &entry :
         tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(box)))
      if (is_crossed(entry.second, {a, b}, tolerance, rim))
        found.push_back(entry.second);
    std::sort(found.begin(), found.end());
    return found;
  }



  template <int dim>
  bool Walls<dim>::is_crossed(const unsigned int facet, const std::pair<Point<dim>, Point<dim>> &segment,
                              const double tolerance, const double rim) const
  {
    const auto &[a, b]      = segment;
    const double distance_a = signed_distance(facet, a);
    const double distance_b = signed_distance(facet, b);
    return distance_a != distance_b && std::min(distance_a, distance_b) <= -tolerance &&
           std::max(distance_a, distance_b) >= tolerance &&
           is_above(facet, a + distance_a / (distance_a - distance_b) * (b - a), rim);
  }



  template <int dim>
  bool Walls<dim>::is_hidden(const unsigned int facet, const Point<dim> &point) const
  {
    // Not quite to the foot: of facets that lie upon each other none hides the other.
    const std::vector<unsigned int> between =
      crossed(point, point - (1. - 1e-3) * signed_distance(facet, point) * normals[facet], 0., 0.);
    return std::any_of(between.begin(), between.end(),
                       [&](const unsigned int other) { return other != facet && all_facets[other].lands; });
  }



  template class Walls<2>;
  template class Walls<3>;
} // namespace Lahar
