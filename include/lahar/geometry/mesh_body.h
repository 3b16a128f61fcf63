// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_mesh_body_h
#define lahar_geometry_mesh_body_h

#include <lahar/boundary/walls.h>
#include <lahar/geometry/fluid_body.h>
#include <lahar/remeshing/delaunay.h>

namespace Lahar
{
  /**
   * The simplices of a physical group of a mesh file. Its particles are the nodes, whatever the mesh size is; its contour
   * consists of the faces with one simplex, so two parts that do not share their nodes have one each.
   */
  template <int dim>
  class MeshBody : public FluidBody<dim>
  {
  public:
    /// @param simplices of numbers of @p nodes, each with a volume.
    MeshBody(const std::string &name, const std::vector<Point<dim>> &nodes,
             const std::vector<Simplex<dim>> &simplices);

    Box<dim> box() const override;
    double volume() const override;

    /// Far from the contour at least the length of its longest edge.
    double signed_distance(const Point<dim> &point) const override;

    double roughness() const override;
    double estimate_size(const double) const override;
    std::vector<Point<dim>> fill(const MeshSize<dim> &) const override;

    /// The mean length of the edges at each node.
    std::vector<double> distances(const std::vector<Point<dim>> &, const MeshSize<dim> &) const override;

    std::vector<std::array<Point<dim>, dim>> contour() const override;

  private:
    bool is_inside(const Point<dim> &point) const;

    std::vector<Point<dim>> nodes;
    std::vector<Simplex<dim>> cells; ///< positively oriented
    std::vector<double> edge_length; ///< the mean at each node
    Walls<dim> facets;               ///< the contour
    double longest_edge = 0.;        ///< of the contour

    using CellBox = std::pair<BoundingBox<dim>, unsigned int>;
    RTree<CellBox> tree; ///< of the cells
  };
} // namespace Lahar

#endif
