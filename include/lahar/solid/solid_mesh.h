// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_solid_solid_mesh_h
#define lahar_solid_solid_mesh_h

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * The mesh of all solids: simplices with linear or quadratic displacements, made once for the whole run.
   *
   * It stands in the undeformed configuration, with straight edges. Node i is degree of freedom i of dof_handler(); the
   * nodes on the contour come first. Cells belong to the body that their material id names. Shape gradients, volumes
   * and masses at the quadrature points are kept, since they never change.
   *
   * To the fluid the contour consists of facets that join neighbouring nodes: a quadratic edge counts as two segments,
   * a quadratic face as four triangles. The gap between them and the curved edge is κ l²/32 for the curvature κ of an
   * edge of length l.
   */
  template <int dim>
  class SolidMesh
  {
  public:
    using Facet = std::array<unsigned int, dim>;

    /// @param degree of the displacements, 1 or 2.
    explicit SolidMesh(const unsigned int degree);

    /// Make the mesh. @p cells have their body in material_id.
    void reinit(const std::vector<Point<dim>> &vertices, const std::vector<CellData<dim>> &cells);

    unsigned int n_nodes() const
    {
      return dofs.n_dofs();
    }

    unsigned int n_contour_nodes() const
    {
      return n_on_contour;
    }

    unsigned int n_cells() const
    {
      return body_of_cell.size();
    }

    unsigned int nodes_per_cell() const
    {
      return fe.dofs_per_cell;
    }

    unsigned int points_per_cell() const
    {
      return n_points;
    }

    /// The nodes of all cells, nodes_per_cell() each, in deal.II's local order (corners first).
    const std::vector<unsigned int> &cell_nodes() const
    {
      return nodes;
    }

    const unsigned int *cell_nodes(const unsigned int cell) const
    {
      return &nodes[cell * nodes_per_cell()];
    }

    unsigned int body(const unsigned int cell) const
    {
      return body_of_cell[cell];
    }

    /// A body that the node belongs to.
    unsigned int body_of_node(const unsigned int node) const
    {
      return node_body[node];
    }

    /// X of a node.
    const Point<dim> &reference_position(const unsigned int node) const
    {
      return support_points[node];
    }

    /// ∂N_I/∂X at quadrature point @p q, nodes_per_cell() entries.
    const Tensor<1, dim> *gradients(const unsigned int cell, const unsigned int q) const
    {
      return &shape_gradients[(cell * n_points + q) * nodes_per_cell()];
    }

    /// Undeformed volume of quadrature point @p q.
    double volume(const unsigned int cell, const unsigned int q) const
    {
      return volumes[cell * n_points + q];
    }

    /// ∫ N_I N_J over the undeformed cell.
    double mass(const unsigned int cell, const unsigned int I, const unsigned int J) const
    {
      return masses[(cell * nodes_per_cell() + I) * nodes_per_cell() + J];
    }

    /// Flat facets between nodes of the contour; their normals (see Walls) point out of the solid.
    const std::vector<Facet> &contour() const
    {
      return facets;
    }

    /// ∂x/∂X at quadrature point @p q for the given positions of the nodes; the out-of-plane component is 1 in 2D.
    Tensor<2, 3> deformation_gradient(const unsigned int cell, const unsigned int q,
                                      const std::vector<Point<dim>> &position) const;

    const DoFHandler<dim> &dof_handler() const
    {
      return dofs;
    }

    const Mapping<dim> &mapping() const
    {
      return map;
    }

  private:
    void find_contour();
    void compute_shape_data();

    FE_SimplexP<dim> linear, fe;
    MappingFE<dim> map;
    Triangulation<dim> tria;
    DoFHandler<dim> dofs;
    unsigned int n_points = 0, n_on_contour = 0;

    std::vector<unsigned int> nodes, body_of_cell, node_body;
    std::vector<Point<dim>> support_points;
    std::vector<Tensor<1, dim>> shape_gradients;
    std::vector<double> volumes, masses;
    std::vector<Facet> facets;
  };
} // namespace Lahar

#endif
