// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/solid/solids.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  void Solids<dim>::find_drawn(const std::vector<Point<dim>> &vertices)
  {
    drawn.resize(solid_mesh->n_nodes());
    const std::vector<Point<dim>> &unit = solid_mesh->dof_handler().get_fe().get_unit_support_points();
    for (const auto &cell : solid_mesh->dof_handler().active_cell_iterators())
      for (unsigned int k = 0; k < solid_mesh->nodes_per_cell(); ++k)
      {
        const unsigned int node = solid_mesh->cell_nodes(cell->active_cell_index())[k];
        if (!bodies[cell->material_id()].ground)
        {
          drawn[node] = solid_mesh->reference_position(node);
          continue;
        }
        const Point<dim> first = vertices[cell->vertex_index(0)];
        drawn[node]            = first;
        for (unsigned int d = 0; d < dim; ++d)
          drawn[node] += unit[k][d] * (vertices[cell->vertex_index(d + 1)] - first);
      }
  }



  template <int dim>
  void Solids<dim>::find_unevenness()
  {
    uneven = 0.;
    for (const auto &facet : solid_mesh->contour())
    {
      const std::optional<Ground<dim>> &ground = bodies[solid_mesh->body_of_node(facet[0])].ground;
      if (!ground || std::any_of(facet.begin(), facet.end(), [&](const unsigned int node) {
            return std::abs(drawn[node][dim - 1]) > place_tolerance;
          }))
        continue;
      Point<dim> centre;
      const auto look_at = [&](const Point<dim> &place) {
        uneven = std::max(uneven, std::abs(place[dim - 1] - ground->elevation(place)));
      };
      for (unsigned int v = 0; v < dim; ++v)
      {
        const Point<dim> &a = solid_mesh->reference_position(facet[v]);
        look_at(a + 0.5 * (solid_mesh->reference_position(facet[(v + 1) % dim]) - a));
        centre += Tensor<1, dim>(a) / dim;
      }
      look_at(centre);
    }
  }



  template <int dim>
  Point<dim> Solids<dim>::drawn_middle(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                       const unsigned int face) const
  {
    if (!bodies[cell->material_id()].ground)
      return cell->face(face)->center();
    Point<dim> middle;
    const unsigned int *nodes = solid_mesh->cell_nodes(cell->active_cell_index());
    for (unsigned int v = 0; v < dim; ++v)
      middle += Tensor<1, dim>(drawn[nodes[cell->reference_cell().face_to_cell_vertices(face, v, 1)]]) / dim;
    return middle;
  }



  template void Solids<2>::find_drawn(const std::vector<Point<2>> &);
  template void Solids<3>::find_drawn(const std::vector<Point<3>> &);
  template void Solids<2>::find_unevenness();
  template void Solids<3>::find_unevenness();
  template Point<2> Solids<2>::drawn_middle(const DoFHandler<2>::active_cell_iterator &,
                                            const unsigned int) const;
  template Point<3> Solids<3>::drawn_middle(const DoFHandler<3>::active_cell_iterator &,
                                            const unsigned int) const;
} // namespace Lahar
