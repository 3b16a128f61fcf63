// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_walls_h
#define lahar_geometry_walls_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/numerics/rtree.h>

#include <array>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// One flat piece of a rigid wall: a segment in 2D, a triangle in 3D.
  template <int dim>
  struct WallFacet
  {
    std::array<Point<dim>, dim> corners;
    bool lands            = false; ///< fluid lands on it (WallContact); else it carries particles of its own
    unsigned int boundary = 0;     ///< the number of the case's boundary that it belongs to
    bool moves            = false; ///< whether that boundary moves in the run
    bool sticks           = false; ///< fluid that has landed goes with it, instead of sliding
  };

  /// Fluid particles that lie on a facet are this times their spacing away from it, on their side of it.
  constexpr double contact_offset = 1e-8;

  /// Facets go on smoothly into each other where the cosine of the angle between their normals exceeds this: a particle
  /// slides from one to the next. At sharper edges it belongs to both.
  constexpr double smooth_joint = 0.7;

  /**
   * The rigid walls of a case, as flat facets.
   *
   * Fluid lands on them (WallContact), or they carry particles that hold it through the cells that join both.
   */
  template <int dim>
  class Walls
  {
  public:
    Walls() = default;
    /// @param names of the boundaries that the facets' numbers mean, if they are needed.
    explicit Walls(const std::vector<WallFacet<dim>> &facets, const std::vector<std::string> &names = {});

    const std::vector<WallFacet<dim>> &facets() const
    {
      return all_facets;
    }

    const std::vector<std::string> &boundary_names() const
    {
      return names;
    }

    /// Unit normal of a facet; its side follows from the order of the corners.
    const Tensor<1, dim> &normal(const unsigned int facet) const
    {
      return normals[facet];
    }

    /// Signed distance of @p point from the plane of @p facet, positive on the side of the normal.
    double signed_distance(const unsigned int facet, const Point<dim> &point) const;

    /// Whether the foot of @p point on the plane of @p facet lies in the facet, enlarged by @p tolerance at its rim.
    bool is_above(const unsigned int facet, const Point<dim> &point, const double tolerance) const;

    /// Facets whose bounding box, enlarged by @p distance, holds @p point.
    std::vector<unsigned int> near(const Point<dim> &point, const double distance) const;

    /**
     * Facets, enlarged by @p rim at their rim, that the segment from @p a to @p b passes through from one side to the
     * other. A segment that ends within @p tolerance of a facet does not pass through it.
     */
    std::vector<unsigned int> crossed(const Point<dim> &a, const Point<dim> &b, const double tolerance,
                                      const double rim) const;

    /// Whether the segment passes through one facet in this sense.
    bool is_crossed(const unsigned int facet, const std::pair<Point<dim>, Point<dim>> &segment,
                    const double tolerance, const double rim) const;

    /// Whether another facet without particles lies between @p point and its foot on the plane of @p facet.
    bool is_hidden(const unsigned int facet, const Point<dim> &point) const;

  private:
    std::vector<WallFacet<dim>> all_facets;
    std::vector<std::string> names; ///< of the boundaries
    std::vector<Tensor<1, dim>> normals;

    using Box = std::pair<BoundingBox<dim>, unsigned int>;
    RTree<Box> tree;
  };
} // namespace Lahar

#endif
