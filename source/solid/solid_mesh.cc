// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>

#include <lahar/solid/solid_mesh.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  SolidMesh<dim>::SolidMesh(const unsigned int degree)
    : linear(1)
    , fe(degree)
    , map(linear)
    , dofs(tria)
  {}



  template <int dim>
  void SolidMesh<dim>::reinit(const std::vector<Point<dim>> &vertices,
                              const std::vector<CellData<dim>> &cells)
  {
    dofs.clear();
    tria.clear();
    tria.create_triangulation(vertices, cells, SubCellData());
    dofs.reinit(tria);
    dofs.distribute_dofs(fe);

    find_contour(); // numbers the nodes anew
    nodes.clear();
    body_of_cell.clear();
    node_body.assign(n_nodes(), 0);
    std::vector<types::global_dof_index> indices(fe.dofs_per_cell);
    for (const auto &cell : dofs.active_cell_iterators())
    {
      cell->get_dof_indices(indices);
      nodes.insert(nodes.end(), indices.begin(), indices.end());
      body_of_cell.push_back(cell->material_id());
      for (const auto i : indices)
        node_body[i] = cell->material_id();
    }
    support_points.resize(n_nodes());
    DoFTools::map_dofs_to_support_points(map, dofs, support_points);
    compute_shape_data();
  }



  namespace
  {
    /// The local node in the middle of the edge between two corners.
    template <int dim>
    unsigned int middle_node(const FiniteElement<dim> &fe, const unsigned int a, const unsigned int b)
    {
      const std::vector<Point<dim>> &nodes = fe.get_unit_support_points();
      const Point<dim> middle              = nodes[a] + 0.5 * (nodes[b] - nodes[a]);
      for (unsigned int node = 0; node < nodes.size(); ++node)
        if (nodes[node].distance(middle) < 1e-10)
          return node;
      Assert(false, ExcInternalError());
      return 0;
    }

    /// Divide a facet of the contour, given by its corners, at the middles of its edges.
    std::vector<std::array<unsigned int, 2>> divided(const FiniteElement<2> &fe,
                                                     const std::array<unsigned int, 2> &corners)
    {
      const unsigned int middle = middle_node(fe, corners[0], corners[1]);
      return {{{corners[0], middle}}, {{middle, corners[1]}}};
    }

    std::vector<std::array<unsigned int, 3>> divided(const FiniteElement<3> &fe,
                                                     const std::array<unsigned int, 3> &corners)
    {
      const auto [a, b, c]  = corners;
      const unsigned int ab = middle_node(fe, a, b), bc = middle_node(fe, b, c), ca = middle_node(fe, c, a);
      return {{{a, ab, ca}}, {{ab, b, bc}}, {{ca, bc, c}}, {{ab, bc, ca}}};
    }

    double height_over(const std::array<Point<2>, 2> &facet, const Point<2> &point)
    {
      return cross_product_2d(facet[1] - facet[0]) * (point - facet[0]);
    }

    double height_over(const std::array<Point<3>, 3> &facet, const Point<3> &point)
    {
      return cross_product_3d(facet[1] - facet[0], facet[2] - facet[0]) * (point - facet[0]);
    }
  } // namespace



  template <int dim>
  void SolidMesh<dim>::find_contour()
  {
    facets.clear();
    std::vector<types::global_dof_index> indices(fe.dofs_per_cell);
    std::vector<bool> on_contour(n_nodes(), false);
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
        {
          Facet corners;
          std::array<Point<dim>, dim> points;
          unsigned int opposite = (dim + 1) * dim / 2;
          for (unsigned int v = 0; v < dim; ++v)
          {
            corners[v] = cell->reference_cell().face_to_cell_vertices(f, v, 1);
            points[v]  = cell->vertex(corners[v]);
            opposite -= corners[v];
          }
          if (height_over(points, cell->vertex(opposite)) > 0.)
            std::swap(corners[0], corners[1]);

          cell->get_dof_indices(indices);
          for (Facet facet : fe.degree == 1 ? std::vector<Facet>{corners} : divided(fe, corners))
          {
            for (unsigned int &node : facet)
            {
              node             = indices[node];
              on_contour[node] = true;
            }
            facets.push_back(facet);
          }
        }

    n_on_contour = std::count(on_contour.begin(), on_contour.end(), true);
    std::vector<types::global_dof_index> number(n_nodes());
    for (unsigned int i = 0, next = 0, next_inside = n_on_contour; i < n_nodes(); ++i)
      number[i] = on_contour[i] ? next++ : next_inside++;
    dofs.renumber_dofs(number);
    for (Facet &facet : facets)
      for (unsigned int &node : facet)
        node = number[node];
  }



  template <int dim>
  void SolidMesh<dim>::compute_shape_data()
  {
    const QGaussSimplex<dim> quadrature(fe.degree);
    const QWitherdenVincentSimplex<dim> mass_quadrature(fe.degree + 1); // of degree 2 fe.degree and more
    FEValues<dim> values(map, fe, quadrature, update_gradients | update_JxW_values);
    FEValues<dim> mass_values(map, fe, mass_quadrature, update_values | update_JxW_values);
    n_points = quadrature.size();
    shape_gradients.clear();
    volumes.clear();
    masses.clear();
    for (const auto &cell : dofs.active_cell_iterators())
    {
      values.reinit(cell);
      for (unsigned int q = 0; q < n_points; ++q)
      {
        volumes.push_back(values.JxW(q));
        for (unsigned int I = 0; I < fe.dofs_per_cell; ++I)
          shape_gradients.push_back(values.shape_grad(I, q));
      }
      mass_values.reinit(cell);
      for (unsigned int I = 0; I < fe.dofs_per_cell; ++I)
        for (unsigned int J = 0; J < fe.dofs_per_cell; ++J)
        {
          double sum = 0.;
          for (unsigned int q = 0; q < mass_quadrature.size(); ++q)
            sum += mass_values.shape_value(I, q) * mass_values.shape_value(J, q) * mass_values.JxW(q);
          masses.push_back(sum);
        }
    }
  }



  template <int dim>
  Tensor<2, 3> SolidMesh<dim>::deformation_gradient(const unsigned int cell, const unsigned int q,
                                                    const std::vector<Point<dim>> &position) const
  {
    Tensor<2, 3> F;
    if (dim == 2)
      F[2][2] = 1.;
    const Tensor<1, dim> *G = gradients(cell, q);
    const unsigned int *I   = cell_nodes(cell);
    for (unsigned int k = 0; k < nodes_per_cell(); ++k)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          F[i][j] += position[I[k]][i] * G[k][j];
    return F;
  }



  template class SolidMesh<2>;
  template class SolidMesh<3>;
} // namespace Lahar
