// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/harmful_midpoints.h>
#include <lahar/remeshing/wall_faces.h>

#include <algorithm>
#include <array>

namespace Lahar
{
  namespace
  {
    /// No particle is inserted nearer to the free surface than this times h, but on it.
    constexpr double smallest_depth = 0.5;

    /// The rim of a wall counts this times h wider.
    constexpr double wall_rim = 1e-3;
  } // namespace



  template <int dim>
  std::vector<bool> harmful_midpoints(const std::vector<std::pair<unsigned int, unsigned int>> &edges,
                                      const ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                      const FluidMesh<dim> &mesh, const double smallest_distance)
  {
    const unsigned int n = edges.size();
    std::vector<bool> harmful(n, false), near_surface(n, false), on_surface(n, false);
    if (dim == 2)
    {
      // The chord of a wall that bulges: its middle lies in the wall.
      for (unsigned int e = 0; e < n; ++e)
        for (const unsigned int i : {edges[e].first, edges[e].second})
          if (cloud.kind[i] == ParticleKind::fluid)
          {
            const Point<dim> middle = cloud.position[edges[e].first] +
                                      0.5 *
                                        (cloud.position[edges[e].second] - cloud.position[edges[e].first]);
            for (const unsigned int facet : walls.crossed(cloud.position[i], middle, 0., 0.))
              harmful[e] = harmful[e] || walls.facets()[facet].lands;
          }
      return harmful;
    }
    std::vector<std::vector<unsigned int>> edges_at(cloud.size());
    std::vector<Point<dim>> middle;
    for (const auto &[a, b] : edges)
    {
      edges_at[a].push_back(middle.size());
      edges_at[b].push_back(middle.size());
      middle.push_back(cloud.position[a] + 0.5 * (cloud.position[b] - cloud.position[a]));
    }
    const auto h = [&](const unsigned int e) {
      return 0.5 * (cloud.spacing[edges[e].first] + cloud.spacing[edges[e].second]);
    };
    const auto is_end = [&](const unsigned int i, const unsigned int e) {
      return i == edges[e].first || i == edges[e].second;
    };

    for (const Simplex<dim> &cell : mesh.particle_cells())
      for (const unsigned int a : cell)
        for (const unsigned int e : edges_at[a])
          if (a == edges[e].first && std::find(cell.begin(), cell.end(), edges[e].second) != cell.end())
            for (const unsigned int c : cell)
              if (!is_end(c, e) && middle[e].distance(cloud.position[c]) < smallest_distance * h(e))
                harmful[e] = true;

    for (const BoundaryFace &face : free_surface_faces(mesh, cloud, walls))
    {
      const Simplex<dim> &cell = mesh.particle_cells()[face.cell];
      std::array<Point<dim>, dim> x;
      for (unsigned int c = 0, i = 0; c <= dim; ++c)
        if (c != face.opposite)
          x[i++] = cloud.position[cell[c]];
      Tensor<1, dim> normal;
      if constexpr (dim == 3)
        normal = cross_product_3d(x[1] - x[0], x[2] - x[0]);
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
          for (const unsigned int e : edges_at[cell[c]])
          {
            const unsigned int n_ends = std::count_if(cell.begin(), cell.end(), [&](const unsigned int i) {
              return i != cell[face.opposite] && is_end(i, e);
            });
            const double depth        = std::abs(normal * (middle[e] - x[0])) / normal.norm();
            on_surface[e]             = on_surface[e] || n_ends == 2;
            near_surface[e]           = near_surface[e] || depth < smallest_depth * h(e);
          }
    }
    // Both ways from fluid to the middle must be free; an end that is a wall's lies in it.
    for (unsigned int e = 0; e < n; ++e)
    {
      harmful[e] = harmful[e] || (near_surface[e] && !on_surface[e]);
      for (const unsigned int i : {edges[e].first, edges[e].second})
        if (cloud.kind[i] == ParticleKind::fluid && !harmful[e])
          harmful[e] = !walls.crossed(cloud.position[i], middle[e], 0., wall_rim * h(e)).empty();
    }
    return harmful;
  }



  template std::vector<bool> harmful_midpoints(const std::vector<std::pair<unsigned int, unsigned int>> &,
                                               const ParticleCloud<2> &, const Walls<2> &,
                                               const FluidMesh<2> &, const double);
  template std::vector<bool> harmful_midpoints(const std::vector<std::pair<unsigned int, unsigned int>> &,
                                               const ParticleCloud<3> &, const Walls<3> &,
                                               const FluidMesh<3> &, const double);
} // namespace Lahar
