// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_packed_points_h
#define lahar_geometry_packed_points_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// Given points, of which those near a place are found fast, with four bytes for each: they are sorted by halving
  /// along one direction after the other (a k-d tree without nodes).
  template <int dim>
  class PackedPoints
  {
  public:
    /// @p points must outlive this object.
    explicit PackedPoints(const std::vector<Point<dim>> &points)
      : points(points)
      , order(points.size())
    {
      std::iota(order.begin(), order.end(), 0U);
      divide(0, order.size(), 0);
    }

    /// Whether a point nearer to @p place than @p distance (m) fulfils @p condition, a function of its index.
    template <typename Condition>
    bool any_near(const Point<dim> &place, const double distance, const Condition &condition) const
    {
      return search(place, distance, condition, 0, order.size(), 0);
    }

  private:
    /// So many points are looked at one by one.
    static constexpr std::size_t n_few = 8;

    void divide(const std::size_t begin, const std::size_t end, const unsigned int axis)
    {
      if (end - begin <= n_few)
        return;
      const std::size_t middle = begin + (end - begin) / 2;
      std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                       [&](const unsigned int a, const unsigned int b) {
                         return points[a][axis] < points[b][axis];
                       });
      divide(begin, middle, (axis + 1) % dim);
      divide(middle + 1, end, (axis + 1) % dim);
    }

    template <typename Condition>
    bool search(const Point<dim> &place, const double distance, const Condition &condition,
                const std::size_t begin, const std::size_t end, const unsigned int axis) const
    {
      const auto is_it = [&](const unsigned int i) {
        return points[i].distance_square(place) < distance * distance && condition(i);
      };
      if (end - begin <= n_few)
        return std::any_of(order.begin() + begin, order.begin() + end, is_it);
      const std::size_t middle = begin + (end - begin) / 2;
      const double cut         = points[order[middle]][axis];
      return is_it(order[middle]) ||
             (place[axis] - distance <= cut &&
              search(place, distance, condition, begin, middle, (axis + 1) % dim)) ||
             (place[axis] + distance >= cut &&
              search(place, distance, condition, middle + 1, end, (axis + 1) % dim));
    }

    const std::vector<Point<dim>> &points;
    std::vector<unsigned int> order;
  };
} // namespace Lahar

#endif
