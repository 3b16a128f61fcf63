// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/point_set.h>

namespace Lahar
{
  template <int dim>
  std::vector<unsigned int> PointSet<dim>::near(const Point<dim> &point, const double distance) const
  {
    namespace bgi = boost::geometry::index;
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d] = point[d] - distance;
      upper[d] = point[d] + distance;
    }
    const BoundingBox<dim> box(std::make_pair(lower, upper));
    std::vector<unsigned int> numbers;
    for (auto entry = tree.qbegin(bgi::intersects(box)); entry != tree.qend(); ++entry)
      if (entry->first.distance_square(point) < distance * distance)
        numbers.push_back(entry->second);
    return numbers;
  }



  template <int dim>
  void PointSet<dim>::insert(const Point<dim> &point)
  {
    tree.insert({point, tree.size()});
  }



  template <int dim>
  bool PointSet<dim>::insert_if_free(const Point<dim> &point, const double distance)
  {
    const bool is_free = near(point, distance).empty();
    if (is_free)
      insert(point);
    return is_free;
  }



  template class PointSet<2>;
  template class PointSet<3>;
} // namespace Lahar
