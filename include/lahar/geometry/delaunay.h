// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_delaunay_h
#define lahar_geometry_delaunay_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// A simplex as the indices of its dim+1 corners, positively oriented.
  template <int dim>
  using Simplex = std::array<unsigned int, dim + 1>;

  /// The even permutation of a simplex's corners that has the smallest first and, in 3D, the second smallest next.
  template <int dim>
  inline Simplex<dim> canonical(Simplex<dim> simplex)
  {
    const unsigned int first = std::min_element(simplex.begin(), simplex.end()) - simplex.begin();
    if (dim == 2)
      std::rotate(simplex.begin(), simplex.begin() + first, simplex.end());
    else if (first != 0)
    {
      std::swap(simplex[0], simplex[first]);
      std::swap(simplex[1 + first % dim], simplex[1 + (first + 1) % dim]);
    }
    if (dim == 3)
      std::rotate(simplex.begin() + 1, std::min_element(simplex.begin() + 1, simplex.end()), simplex.end());
    return simplex;
  }

  /**
   * The Delaunay triangulation of a growing part of given points (CGAL, exact predicates; 2D triangles, 3D tetrahedra).
   *
   * It is unique: where more than dim+1 points lie on an empty sphere, CGAL lifts them off it by infinitesimal amounts
   * that depend on the lexicographic order of their coordinates alone (Devillers & Teillaud 2003); of points in the
   * same place only the one with the smallest index gets simplices. So the simplices depend neither on the order in
   * which the points are inserted nor on points that do not lie in a simplex's circumsphere: what the triangulation of
   * a part has, and no other point contradicts, the triangulation of all points has too, and the other way round.
   */
  template <int dim>
  class DelaunayTriangulation
  {
  public:
    /// @p points must outlive this object.
    explicit DelaunayTriangulation(const std::vector<Point<dim>> &points);
    ~DelaunayTriangulation();

    /// Insert more of the points, by index. Each may be inserted once.
    void insert(const std::vector<unsigned int> &indices);

    /// The simplices; none for fewer than dim+1 points and for points on one line (in one plane).
    std::vector<Simplex<dim>> simplices() const;

  private:
    struct Implementation;

    const std::vector<Point<dim>> &points;
    std::vector<unsigned int> inserted;
    std::unique_ptr<Implementation> implementation;
  };

  /// Whether a point lies in the circumball of a positively oriented simplex, its surface included; exact.
  template <int dim>
  bool in_circumball(const std::array<Point<dim>, dim + 1> &corners, const Point<dim> &point);

  /// The Delaunay simplices of all @p points.
  template <int dim>
  std::vector<Simplex<dim>> delaunay(const std::vector<Point<dim>> &points);

  /**
   * The constrained Delaunay triangulation of a growing part of given points: all segments between some of them, which
   * may meet at their ends only, are edges. A triangle's circumcircle holds no point that can be seen from the triangle
   * past the segments.
   */
  class ConstrainedDelaunay
  {
  public:
    /// The arguments must outlive this object. The first @p n_required segments must be edges, others are left out where
    /// they cross those before them.
    ConstrainedDelaunay(const std::vector<Point<2>> &points,
                        const std::vector<std::array<unsigned int, 2>> &segments,
                        const unsigned int n_required = numbers::invalid_unsigned_int);
    ~ConstrainedDelaunay();

    /**
     * Insert more of the points, by index, the ends of all segments with the first ones.
     * @throws RunError if two segments that are required cross, with the place.
     */
    void insert(const std::vector<unsigned int> &indices);

    /// As DelaunayTriangulation::simplices().
    std::vector<Simplex<2>> simplices() const;

    /// By segment whether it was no edge of the triangulation of the points inserted first without constraints.
    const std::vector<bool> &forced() const
    {
      return is_forced;
    }

  private:
    struct Implementation;

    void insert_segments();

    const std::vector<Point<2>> &points;
    const std::vector<std::array<unsigned int, 2>> &segments;
    unsigned int n_required;
    std::vector<unsigned int> inserted;
    std::vector<bool> is_forced;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace Lahar

#endif
