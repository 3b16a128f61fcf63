// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/solid_collision.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// Depth below which what touches has not run into each other, over the size of the contour's facets.
    constexpr double tolerated_depth = 0.1;

    template <int dim>
    Point<dim> meeting(const Walls<dim> &walls, const unsigned int facet, const Point<dim> &a,
                       const Point<dim> &b)
    {
      const double before = walls.signed_distance(facet, a), after = walls.signed_distance(facet, b);
      return a + before / (before - after) * (b - a);
    }

    /// Whether corners of @p facet lie farther than @p depth before and behind the plane of a wall's facet.
    template <int dim>
    bool lies_on_both_sides(const WallFacet<dim> &facet, const Walls<dim> &walls, const unsigned int wall,
                            const double depth)
    {
      double lowest = 0., highest = 0.;
      for (const Point<dim> &corner : facet.corners)
      {
        const double distance = walls.signed_distance(wall, corner);
        lowest                = std::min(lowest, distance);
        highest               = std::max(highest, distance);
      }
      return lowest < -depth && highest > depth;
    }

    /// The edges of facets as pairs of their corners: a facet of the plane is one itself.
    template <int dim>
    constexpr unsigned int n_edges = (dim == 2 ? 1 : 3);
  } // namespace



  template <int dim>
  std::optional<typename SolidCollision<dim>::Place>
  SolidCollision<dim>::find(const SolidMesh<dim> &mesh, const std::vector<Point<dim>> &old_position,
                            const std::vector<Point<dim>> &position, const WallStep<dim> &step)
  {
    const Walls<dim> &walls = step.end();
    std::vector<WallFacet<dim>> facets, drawn_facets;
    double size = 0.;
    for (const auto &nodes : mesh.contour())
    {
      WallFacet<dim> facet, drawn_facet;
      for (unsigned int v = 0; v < dim; ++v)
      {
        facet.corners[v]       = position[nodes[v]];
        drawn_facet.corners[v] = mesh.reference_position(nodes[v]);
        size += mesh.reference_position(nodes[v]).distance(mesh.reference_position(nodes[(v + 1) % dim]));
      }
      facets.push_back(facet);
      drawn_facets.push_back(drawn_facet);
    }
    if (facets.empty())
      return {};
    const Walls<dim> contour(facets), drawn_contour(drawn_facets);
    const double depth = tolerated_depth * size / (dim * facets.size()), touching = 0.1 * depth;
    const auto reaches_now = [&](const unsigned int i, const unsigned int j, const unsigned int wall) {
      return !walls.is_crossed(wall, {mesh.reference_position(i), mesh.reference_position(j)}, touching, 0.);
    };

    for (unsigned int f = 0; f < facets.size(); ++f)
      for (unsigned int e = 0; e < n_edges<dim>; ++e)
      {
        const auto &nodes   = mesh.contour()[f];
        const Point<dim> &a = facets[f].corners[e], &b = facets[f].corners[(e + 1) % dim];
        const unsigned int i = mesh.body_of_node(nodes[0]);
        for (const unsigned int wall : walls.crossed(a, b, depth, 0.))
          if (reaches_now(nodes[e], nodes[(e + 1) % dim], wall))
            return Place{meeting(walls, wall, a, b), i, wall, 0};
        for (const unsigned int other : contour.crossed(a, b, depth, 0.))
        {
          const auto &others = mesh.contour()[other];
          if (std::none_of(others.begin(), others.end(), [&](const unsigned int node) {
                return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
              }))
            return Place{meeting(contour, other, a, b), i, {}, mesh.body_of_node(others[0])};
        }
      }
    // A wall that enters near a node has a neighbour of the node on each side.
    if constexpr (dim == 2)
    {
      std::vector<unsigned int> next(mesh.n_contour_nodes());
      for (const auto &nodes : mesh.contour())
        next[nodes[0]] = nodes[1];
      for (unsigned int i = 0; i < next.size(); ++i)
      {
        const Point<2> &a = position[i], &middle = position[next[i]], &b = position[next[next[i]]];
        if (cross_product_2d(b - a) * (middle - a) > -1e-3 * (b - a).norm_square()) // not in a hollow
          for (const unsigned int wall : walls.crossed(a, b, depth, 0.))
            if (reaches_now(i, next[next[i]], wall))
              return Place{meeting(walls, wall, a, b), mesh.body_of_node(i), wall, 0};
      }
    }
    for (unsigned int wall = 0; wall < walls.facets().size(); ++wall)
      for (unsigned int e = 0; e < n_edges<dim>; ++e)
      {
        const auto &corners = walls.facets()[wall].corners;
        const Point<dim> &a = corners[e], &b = corners[(e + 1) % dim];
        for (const unsigned int f : contour.crossed(a, b, depth, -depth))
          if (!drawn_contour.is_crossed(f, {a, b}, touching, -touching) &&
              lies_on_both_sides<dim>(facets[f], walls, wall, depth))
            return Place{meeting(contour, f, a, b), mesh.body_of_node(mesh.contour()[f][0]), wall, 0};
      }
    for (unsigned int i = 0; i < mesh.n_contour_nodes(); ++i)
      for (const unsigned int wall : step.crossed(old_position[i], position[i], depth, 0.))
        return Place{meeting(walls, wall, old_position[i], position[i]), mesh.body_of_node(i), wall, 0};
    return {};
  }



  template class SolidCollision<2>;
  template class SolidCollision<3>;
} // namespace Lahar
