#ifndef lahar_remeshing_delaunay_h
#define lahar_remeshing_delaunay_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// A simplex as the indices of its dim+1 corners, positively oriented.
  template <int dim>
  using Simplex = std::array<unsigned int, dim + 1>;

  /**
   * The Delaunay simplices of @p points (CGAL, exact predicates; 2D triangles, 3D tetrahedra).
   *
   * Of points in the same place only one gets simplices. Empty for fewer than dim+1 points and for points on one line
   * (in one plane).
   */
  template <int dim>
  std::vector<Simplex<dim>> delaunay(const std::vector<Point<dim>> &points);

  /**
   * The constrained Delaunay triangles of @p points: all @p segments, which may meet at their ends only, are edges.
   *
   * @param n_forced returns how many segments are no edges of the Delaunay triangulation without constraints.
   * @throws RunError if two segments cross, with the place.
   */
  std::vector<Simplex<2>> constrained_delaunay(const std::vector<Point<2>> &points,
                                               const std::vector<std::array<unsigned int, 2>> &segments,
                                               unsigned int &n_forced);
} // namespace Lahar

#endif
