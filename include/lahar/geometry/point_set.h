// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_point_set_h
#define lahar_geometry_point_set_h

#include <deal.II/numerics/rtree.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// Points, of which those near a place are found fast.
  template <int dim>
  class PointSet
  {
  public:
    /// Numbers of the points nearer to @p point than @p distance (m); points are numbered in the order of insertion.
    std::vector<unsigned int> near(const Point<dim> &point, const double distance) const;

    void insert(const Point<dim> &point);

    /// Insert @p point unless there is one nearer to it than @p distance (m). @return whether it was inserted.
    bool insert_if_free(const Point<dim> &point, const double distance);

  private:
    using Entry = std::pair<Point<dim>, unsigned int>;
    RTree<Entry> tree;
  };
} // namespace Lahar

#endif
