// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/point_tree.h>

#include <algorithm>
#include <limits>

namespace Lahar
{
  namespace
  {
    using Iterator = std::vector<unsigned int>::iterator;

    constexpr unsigned int largest_leaf = 16;

    template <int dim>
    BoundingBox<dim> box_around(const std::vector<Point<dim>> &points, const Iterator begin,
                                const Iterator end)
    {
      std::pair<Point<dim>, Point<dim>> corners(points[*begin], points[*begin]);
      for (Iterator i = begin; i != end; ++i)
        for (unsigned int d = 0; d < dim; ++d)
        {
          corners.first[d]  = std::min(corners.first[d], points[*i][d]);
          corners.second[d] = std::max(corners.second[d], points[*i][d]);
        }
      return BoundingBox<dim>(corners);
    }

    /// Move those that are first along the longest side of the box before @p middle, the others behind it.
    template <int dim>
    void divide_at(const std::vector<Point<dim>> &points, const BoundingBox<dim> &box, const Iterator begin,
                   const Iterator middle, const Iterator end)
    {
      unsigned int direction = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (box.side_length(d) > box.side_length(direction))
          direction = d;
      std::nth_element(begin, middle, end, [&](const unsigned int i, const unsigned int j) {
        return points[i][direction] != points[j][direction] ? points[i][direction] < points[j][direction]
                                                            : i < j;
      });
    }

    template <int dim>
    double distance_square(const BoundingBox<dim> &box, const Point<dim> &point)
    {
      double sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double outside = std::max({box.lower_bound(d) - point[d], point[d] - box.upper_bound(d), 0.});
        sum += outside * outside;
      }
      return sum;
    }
  } // namespace



  template <int dim>
  PointTree<dim>::PointTree(const std::vector<Point<dim>> &points, const std::vector<unsigned int> &indices)
    : points(points)
    , order(indices)
  {
    if (order.empty())
      return;
    nodes.push_back(
      {box_around(points, order.begin(), order.end()), 0, static_cast<unsigned int>(order.size()), 0});
    for (unsigned int node = 0; node < nodes.size(); ++node)
      if (nodes[node].end - nodes[node].begin > largest_leaf)
        divide(node);
  }



  template <int dim>
  void PointTree<dim>::divide(const unsigned int node)
  {
    const unsigned int begin = nodes[node].begin, end = nodes[node].end, middle = begin + (end - begin) / 2;
    divide_at(points, nodes[node].box, order.begin() + begin, order.begin() + middle, order.begin() + end);
    nodes[node].first_half = nodes.size();
    nodes.push_back({box_around(points, order.begin() + begin, order.begin() + middle), begin, middle, 0});
    nodes.push_back({box_around(points, order.begin() + middle, order.begin() + end), middle, end, 0});
  }



  template <int dim>
  unsigned int PointTree<dim>::nearest_in_ball(const Point<dim> &target, const Point<dim> &centre,
                                               const double radius,
                                               const std::function<bool(const unsigned int)> &counts) const
  {
    unsigned int nearest = numbers::invalid_unsigned_int;
    double shortest      = std::numeric_limits<double>::infinity();
    std::vector<unsigned int> visited;
    if (!nodes.empty())
      visited.push_back(0);
    while (!visited.empty())
    {
      const Node &node = nodes[visited.back()];
      visited.pop_back();
      if (distance_square(node.box, centre) > radius * radius || distance_square(node.box, target) > shortest)
        continue;
      if (node.first_half != 0)
      {
        // The half that is nearer to the target first.
        const bool second_is_nearer = distance_square(nodes[node.first_half + 1].box, target) <
                                      distance_square(nodes[node.first_half].box, target);
        visited.push_back(node.first_half + !second_is_nearer);
        visited.push_back(node.first_half + second_is_nearer);
        continue;
      }
      for (unsigned int k = node.begin; k < node.end; ++k)
      {
        const unsigned int i  = order[k];
        const double distance = points[i].distance_square(target);
        if (points[i].distance_square(centre) <= radius * radius &&
            (distance < shortest || (distance == shortest && i < nearest)) && counts(i))
        {
          nearest  = i;
          shortest = distance;
        }
      }
    }
    return nearest;
  }



  template class PointTree<2>;
  template class PointTree<3>;
} // namespace Lahar
