// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_mesh_body_h
#define lahar_geometry_mesh_body_h

#include <lahar/boundary/walls.h>
#include <lahar/geometry/fluid_body.h>
#include <lahar/remeshing/delaunay.h>

namespace Lahar
{
  /**
   * The simplices of a physical group of a mesh file. Its contour consists of the faces with one simplex, so two parts
   * that do not share their nodes have one each.
   *
   * Its particles are the nodes, and where these are not at the distance h, the simplices are bisected until no edge is
   * longer than 1.5 h, and nodes within 0.6 h of others (0.5 h of the contour) are left out, first those inside, then
   * those on even parts of the contour and on its ridges; corners stay.
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
    double estimate_size(const double h) const override;
    std::vector<Point<dim>> fill(const MeshSize<dim> &h) const override;
    /// That of its own points.
    double clearance() const override
    {
      return 0.6;
    }

    std::vector<std::array<Point<dim>, dim>> contour() const override;

  private:
    bool is_inside(const Point<dim> &point) const;

    /// How many directions the normals of the contour have around @p point: 0 inside, 1 on an even part, 2 on a ridge (a
    /// corner in the plane), 3 in a corner.
    unsigned int n_normals_at(const Point<dim> &point) const;

    std::vector<Point<dim>> nodes;
    std::vector<Simplex<dim>> cells; ///< positively oriented
    Walls<dim> facets;               ///< the contour
    double longest_edge = 0.;        ///< of the contour
    double mean_edge    = 0.;        ///< of all simplices

    using CellBox = std::pair<BoundingBox<dim>, unsigned int>;
    RTree<CellBox> tree; ///< of the cells
  };
} // namespace Lahar

#endif
