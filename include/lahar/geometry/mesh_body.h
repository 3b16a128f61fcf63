// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_mesh_body_h
#define lahar_geometry_mesh_body_h

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/fluid_body.h>
#include <lahar/geometry/graded_points.h>
#include <lahar/geometry/walls.h>

namespace Lahar
{
  /**
   * The simplices of physical groups of a mesh file. Its contour consists of the faces that have simplices on one side only,
   * whether parts share their nodes or not.
   *
   * It is a shape, no cloud of particles. In the plane the contour is divided from corner to corner (normals more than 20°
   * apart) into pieces of about h. In space its facets with edges longer than 1.4 h are bisected, and of all corners those
   * 0.7 h from others are taken: the shape's corners always, then those on ridges, then the others. The inside is filled
   * as other bodies are.
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

    double signed_distance(const Point<dim> &point) const override;

    double roughness() const override;
    double estimate_size(const double h) const override;
    DividedPoints<dim> fill(const MeshSize<dim> &h, const MPI_Comm &communicator) const override;
    std::vector<std::array<Point<dim>, dim>> contour() const override;

    /// Points of the contour at the distance @p h, corners first.
    std::vector<Point<dim>> contour_points(const SizeFunction<dim> &h) const;

  private:
    bool is_inside(const Point<dim> &point) const;

    /// How many directions the normals of the contour have around @p point: 0 inside, 1 on an even part, 2 on a ridge (a
    /// corner in the plane), 3 in a corner.
    unsigned int n_normals_at(const Point<dim> &point) const;

    /// Points on the contour h apart or less.
    std::vector<Point<dim>> divided_contour(const SizeFunction<dim> &h) const;

    std::vector<Point<dim>> nodes;
    std::vector<Simplex<dim>> cells; ///< positively oriented
    Walls<dim> facets;               ///< the contour
    std::vector<std::array<unsigned int, dim>>
      facet_nodes;            ///< of the contour; in the plane with the fluid on the left
    double longest_edge = 0.; ///< of the contour
    double mean_edge    = 0.; ///< of all simplices

    using NumberedBox = std::pair<BoundingBox<dim>, unsigned int>;
    RTree<NumberedBox> tree, facet_tree; ///< of the cells and of the contour
  };
} // namespace Lahar

#endif
