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
} // namespace Lahar

#endif
