#include <lahar/remeshing/particle_spacing.h>
#include <lahar/utilities/sort_in_buckets.h>

#include <algorithm>
#include <array>
#include <memory>

namespace Lahar
{
  namespace
  {
    /// A fluid particle this near to a wall particle, over the shortest edge, gives way even on the free surface.
    constexpr double surface_to_wall = 0.3;

    /// A particle nearer to a no-slip wall than this times h gives way.
    constexpr double smallest_gap = 0.1;

    template <int dim>
    bool is_at_wall(const Point<dim> &position, const double h, const Walls<dim> &walls)
    {
      for (const unsigned int facet : walls.near(position, smallest_gap * h))
        if (!walls.facets()[facet].slip &&
            std::abs(walls.signed_distance(facet, position)) < smallest_gap * h &&
            walls.is_above(facet, position, 0.))
          return true;
      return false;
    }

    using Edge = std::pair<unsigned int, unsigned int>;

    /// Every edge of the mesh once, as particle indices.
    template <int dim>
    std::vector<Edge> edges_of(const FluidMesh<dim> &mesh, const unsigned int n_particles)
    {
      std::vector<Edge> edges;
      edges.reserve(mesh.n_cells() * dim * (dim + 1) / 2);
      for (const Simplex<dim> &cell : mesh.particle_cells())
        for (unsigned int a = 0; a <= dim; ++a)
          for (unsigned int b = a + 1; b <= dim; ++b)
            edges.emplace_back(std::min(cell[a], cell[b]), std::max(cell[a], cell[b]));
      sort_in_buckets(edges, n_particles, [](const Edge &edge) { return edge.first; });
      edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
      return edges;
    }

    /// The neighbours of each particle along a plane free surface: previous and next with the fluid on the left.
    class SurfaceChain
    {
    public:
      SurfaceChain(const FluidMesh<2> &mesh, const unsigned int n_particles)
        : links(n_particles, {{none, none}})
      {
        for (const BoundaryFace &face : mesh.boundary_faces())
          if (face.free_surface)
          {
            const Simplex<2> &cell  = mesh.particle_cells()[face.cell];
            const unsigned int from = cell[(face.opposite + 1) % 3], to = cell[(face.opposite + 2) % 3];
            links[from][1] = (links[from][1] == none ? to : ambiguous);
            links[to][0]   = (links[to][0] == none ? from : ambiguous);
          }
      }

      /**
       * Try to merge the surface particles a → b into a: to the place near their middle where the area enclosed by
       * previous, a, b, next stays. @return whether it was done.
       */
      bool merge(ParticleCloud<2> &cloud, unsigned int a, unsigned int b, const std::vector<bool> &removed)
      {
        if (links[a][1] != b)
          std::swap(a, b);
        if (links[a][1] != b || links[b][0] != a)
          return false;
        const unsigned int previous = links[a][0], next = links[b][1];
        if (std::max(previous, next) >= links.size() || previous == next || removed[previous] ||
            removed[next])
          return false;

        const Tensor<1, 2> chord  = cloud.position[next] - cloud.position[previous];
        const Tensor<1, 2> normal = cross_product_2d(chord);
        const auto height         = [&](const unsigned int i) {
          return normal * (cloud.position[i] - cloud.position[previous]);
        };
        const double h = cloud.spacing[a];
        if (chord.norm() < 0.5 * h)
          return false;

        // Twice the area of previous, a, b, next, and of previous, merged, next.
        const double area = height(a) - cross_product_2d(cloud.position[b] - cloud.position[a]) *
                                          (cloud.position[next] - cloud.position[a]);
        const Point<2> middle    = cloud.position[a] + 0.5 * (cloud.position[b] - cloud.position[a]);
        const Tensor<1, 2> shift = (area - normal * (middle - cloud.position[previous])) /
                                   normal.norm_square() * normal;
        if (shift.norm() > 0.5 * h)
          return false;

        cloud.position[a]      = middle + shift;
        cloud.velocity[a]      = 0.5 * (cloud.velocity[a] + cloud.velocity[b]);
        cloud.acceleration[a]  = 0.5 * (cloud.acceleration[a] + cloud.acceleration[b]);
        cloud.pressure[a]      = 0.5 * (cloud.pressure[a] + cloud.pressure[b]);
        cloud.pressure_rate[a] = 0.5 * (cloud.pressure_rate[a] + cloud.pressure_rate[b]);
        links[a][1]            = next;
        links[next][0]         = a;
        return true;
      }

    private:
      static constexpr unsigned int none = -1, ambiguous = -2;
      std::vector<std::array<unsigned, 2>> links;
    };
  } // namespace



  template <int dim>
  void ParticleSpacing<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Particle spacing");
    prm.declare_entry("Shortest edge", "0.6", Patterns::Anything(),
                      "Edges shorter than this times the spacing lose a particle. From 0 to 0.9.");
    prm.declare_entry(
      "Longest edge", "1.5", Patterns::Anything(),
      "Edges longer than this times the spacing get a particle in their middle. From 1.3 to 10.");
    prm.leave_subsection();
  }



  template <int dim>
  void ParticleSpacing<dim>::parse_parameters(Parameters &prm)
  {
    prm.enter_subsection("Particle spacing");
    shortest = prm.get_in_range("Shortest edge", 0., 0.9);
    longest  = prm.get_in_range("Longest edge", 1.3, 10.);
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<bool> ParticleSpacing<dim>::find_removals(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                                        const FluidMesh<dim> &mesh,
                                                        const std::vector<Edge> &edges) const
  {
    const std::vector<bool> on_surface = mesh.on_free_surface(cloud.size());
    // What holds the shape of the domain stays before what lies inside it.
    const auto rank = [&](const unsigned int i) {
      unsigned int rank = on_surface[i] ? dim + 1 : 0;
      for (const int facet : cloud.slip_facets[i])
        rank += (facet != ParticleCloud<dim>::no_facet);
      return rank;
    };

    std::vector<bool> removed(cloud.size(), false), merged(cloud.size(), false);
    for (const unsigned int i : mesh.particles())
      removed[i] = cloud.kind[i] == ParticleKind::fluid &&
                   is_at_wall(cloud.position[i], cloud.spacing[i], walls);

    std::unique_ptr<SurfaceChain> chain;
    for (const auto &[a, b] : edges)
    {
      if (removed[a] || removed[b] || merged[a] || merged[b])
        continue;
      const double h      = 0.5 * (cloud.spacing[a] + cloud.spacing[b]);
      const double length = cloud.position[a].distance(cloud.position[b]);
      if (length >= shortest * h)
        continue;

      const bool a_is_fluid = cloud.kind[a] == ParticleKind::fluid,
                 b_is_fluid = cloud.kind[b] == ParticleKind::fluid;
      if (a_is_fluid != b_is_fluid)
      {
        const unsigned int fluid = a_is_fluid ? a : b;
        if (rank(fluid) == 0 || length < surface_to_wall * shortest * h)
          removed[fluid] = true;
      }
      else if (a_is_fluid)
      {
        if (rank(a) != rank(b))
          removed[rank(a) < rank(b) ? a : b] = true;
        else if (rank(b) == 0)
          removed[b] = true;
        else if (!on_surface[b])
          removed[b] = cloud.slip_facets[a] == cloud.slip_facets[b];
        else if constexpr (dim == 2)
          if (rank(b) == dim + 1)
          {
            if (!chain)
              chain = std::make_unique<SurfaceChain>(mesh, cloud.size());
            if (chain->merge(cloud, a, b, removed))
              removed[b] = merged[a] = true;
          }
      }
    }
    return removed;
  }



  template <int dim>
  std::vector<typename ParticleSpacing<dim>::Edge>
  ParticleSpacing<dim>::find_insertions(const ParticleCloud<dim> &cloud, const std::vector<Edge> &edges,
                                        const std::vector<bool> &removed) const
  {
    std::vector<std::pair<double, Edge>> candidates;
    for (const Edge &edge : edges)
    {
      const auto [a, b] = edge;
      if (removed[a] || removed[b] ||
          (cloud.kind[a] != ParticleKind::fluid && cloud.kind[b] != ParticleKind::fluid))
        continue;
      const double h      = 0.5 * (cloud.spacing[a] + cloud.spacing[b]);
      const double length = cloud.position[a].distance(cloud.position[b]);
      if (length > longest * h)
        candidates.push_back({-length, edge});
    }
    std::sort(candidates.begin(), candidates.end());

    // One division per particle and step, the longest edges first: its other long edges may be gone afterwards.
    std::vector<bool> used(cloud.size(), false);
    std::vector<Edge> divided;
    for (const auto &[length, edge] : candidates)
      if (!used[edge.first] && !used[edge.second])
      {
        used[edge.first] = used[edge.second] = true;
        divided.push_back(edge);
      }
    return divided;
  }



  template <int dim>
  void ParticleSpacing<dim>::adapt(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                   const FluidMesh<dim> &mesh, OldDomain<dim> &old_domain) const
  {
    const std::vector<Edge> edges    = edges_of<dim>(mesh, cloud.size());
    std::vector<bool> removed        = find_removals(cloud, walls, mesh, edges);
    const std::vector<Edge> inserted = find_insertions(cloud, edges, removed);
    if (inserted.empty() && std::find(removed.begin(), removed.end(), true) == removed.end())
      return;

    const unsigned int n_old = cloud.size();
    for (const auto &[a, b] : inserted)
      cloud.append_midpoint(a, b);
    removed.resize(cloud.size(), false);
    std::vector<unsigned int> new_index = cloud.remove(removed);
    new_index.resize(n_old);
    old_domain.renumber(new_index, inserted, cloud.size());
  }



  template class ParticleSpacing<2>;
  template class ParticleSpacing<3>;
} // namespace Lahar
