// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_point_tree_h
#define lahar_remeshing_point_tree_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * Some of given points, sorted by halving along the longest side of their bounding box (a k-d tree), to find points in
   * balls that may be large but hold few.
   */
  template <int dim>
  class PointTree
  {
  public:
    /// @p points must outlive this object.
    PointTree(const std::vector<Point<dim>> &points, const std::vector<unsigned int> &indices);

    /**
     * The point in the ball (its surface included) that is nearest to @p target, of equally near ones that with the
     * smallest index; numbers::invalid_unsigned_int if there is none. @p counts tells which points count.
     */
    unsigned int nearest_in_ball(const Point<dim> &target, const Point<dim> &centre, const double radius,
                                 const std::function<bool(const unsigned int)> &counts) const;

  private:
    /// Half of its parent's points: order[begin] … order[end−1]; its own halves are nodes first_half and first_half+1.
    struct Node
    {
      BoundingBox<dim> box;
      unsigned int begin, end;
      unsigned int first_half; ///< 0 for a leaf
    };

    void divide(const unsigned int node);

    const std::vector<Point<dim>> &points;
    std::vector<unsigned int> order;
    std::vector<Node> nodes;
  };
} // namespace Lahar

#endif
