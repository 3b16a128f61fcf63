#include <boost/serialization/vector.hpp>

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
       * The chain previous, a, b, next around the neighbours of an edge, in either order; empty if there is none, or one
       * of these is among the @p removed.
       */
      std::vector<unsigned int> around(const std::pair<unsigned int, unsigned int> &edge,
                                       const std::vector<bool> &removed) const
      {
        auto [a, b] = edge;
        if (links[a][1] != b)
          std::swap(a, b);
        if (links[a][1] != b || links[b][0] != a)
          return {};
        const unsigned int previous = links[a][0], next = links[b][1];
        if (std::max(previous, next) >= links.size() || previous == next || removed[previous] ||
            removed[next])
          return {};
        return {previous, a, b, next};
      }

    private:
      static constexpr unsigned int none = -1, ambiguous = -2;
      std::vector<std::array<unsigned, 2>> links;
    };

    /**
     * The place near the middle between a and b where one particle encloses the same area with previous and next as the
     * two do: true if there is one not too far away.
     */
    bool find_merged_place(const std::vector<unsigned int> &chain, const ParticleCloud<2> &cloud,
                           Point<2> &place)
    {
      const Point<2> &previous = cloud.position[chain[0]], &a = cloud.position[chain[1]],
                     &b = cloud.position[chain[2]], &next = cloud.position[chain[3]];
      const Tensor<1, 2> chord = next - previous, normal = cross_product_2d(chord);
      const double h = cloud.spacing[chain[1]];
      if (chord.norm() < 0.5 * h)
        return false;
      // Twice the area of previous, a, b, next, and of previous, merged, next.
      const double area        = normal * (a - previous) - cross_product_2d(b - a) * (next - a);
      const Point<2> middle    = a + 0.5 * (b - a);
      const Tensor<1, 2> shift = (area - normal * (middle - previous)) / normal.norm_square() * normal;
      place                    = middle + shift;
      return shift.norm() <= 0.5 * h;
    }
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
  std::vector<typename ParticleSpacing<dim>::Removal>
  ParticleSpacing<dim>::find_candidates(const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh,
                                        const std::vector<Edge> &edges,
                                        const std::vector<bool> &removed) const
  {
    const std::vector<bool> on_surface = mesh.on_free_surface(cloud.size());
    // What holds the shape of the domain stays before what lies inside it.
    const auto rank = [&](const unsigned int i) {
      unsigned int rank = on_surface[i] ? dim + 1 : 0;
      for (const int facet : cloud.slip_facets[i])
        rank += (facet != ParticleCloud<dim>::no_facet);
      return rank;
    };

    std::unique_ptr<SurfaceChain> chains;
    std::vector<Removal> result;
    for (const Edge &edge : edges)
    {
      const auto [a, b] = edge;
      if (removed[a] || removed[b])
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
          result.push_back({length / h, edge, fluid, {}, {}, {}});
      }
      else if (a_is_fluid)
      {
        if (rank(a) != rank(b))
          result.push_back(
            {length / h, edge, rank(a) < rank(b) ? a : b, {}, {rank(a) < rank(b) ? b : a}, {}});
        else if (rank(b) == 0 || (!on_surface[b] && cloud.slip_facets[a] == cloud.slip_facets[b]))
          result.push_back({length / h, edge, b, {}, {a}, {}});
        else if constexpr (dim == 2)
          if (rank(b) == dim + 1)
          {
            if (!chains)
              chains = std::make_unique<SurfaceChain>(mesh, cloud.size());
            const std::vector<unsigned int> chain = chains->around(edge, removed);
            Point<2> place;
            if (!chain.empty() && find_merged_place(chain, cloud, place))
              result.push_back({length / h, edge, b, {a}, {chain[0], chain[3]}, place});
          }
      }
    }
    std::sort(result.begin(), result.end(), [](const Removal &r, const Removal &s) {
      return std::make_pair(r.length, r.edge) < std::make_pair(s.length, s.edge);
    });
    return result;
  }



  template <int dim>
  std::vector<bool> ParticleSpacing<dim>::find_removals(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                                        const FluidMesh<dim> &mesh,
                                                        const std::vector<Edge> &edges,
                                                        const Migration<dim> &migration) const
  {
    std::vector<bool> removed(cloud.size(), false);
    for (const unsigned int i : mesh.particles())
      removed[i] = cloud.kind[i] == ParticleKind::fluid &&
                   is_at_wall(cloud.position[i], cloud.spacing[i], walls);

    // The first removals that change each particle, and that need it as it is.
    const std::vector<Removal> removals = find_candidates(cloud, mesh, edges, removed);
    std::vector<unsigned int> changed_by(cloud.size(), removals.size()), needed_by = changed_by;
    for (unsigned int r = removals.size(); r-- > 0;)
    {
      changed_by[removals[r].removed] = r;
      for (const unsigned int i : removals[r].moved)
        changed_by[i] = r;
      for (const unsigned int i : removals[r].needed)
        needed_by[i] = r;
    }
    for (unsigned int r = 0; r < removals.size(); ++r)
    {
      const Removal &removal    = removals[r];
      const auto has_first_word = [&](const unsigned int i) { return changed_by[i] == r && needed_by[i] > r; };
      if (!has_first_word(removal.removed) ||
          !std::all_of(removal.moved.begin(), removal.moved.end(), has_first_word) ||
          !std::all_of(removal.needed.begin(), removal.needed.end(),
                       [&](const unsigned int i) { return changed_by[i] > r; }))
        continue;
      removed[removal.removed] = true;
      for (const unsigned int a : removal.moved)
      {
        const unsigned int b   = removal.removed;
        cloud.position[a]      = removal.place;
        cloud.velocity[a]      = 0.5 * (cloud.velocity[a] + cloud.velocity[b]);
        cloud.acceleration[a]  = 0.5 * (cloud.acceleration[a] + cloud.acceleration[b]);
        cloud.pressure[a]      = 0.5 * (cloud.pressure[a] + cloud.pressure[b]);
        cloud.pressure_rate[a] = 0.5 * (cloud.pressure_rate[a] + cloud.pressure_rate[b]);
      }
    }

    if (migration.is_alone())
      return removed;
    // What this rank thinks of others' particles may be wrong at the rim of its region.
    std::vector<double> flags(removed.begin(), removed.end());
    migration.update(flags);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      removed[i] = flags[i] > 0.;
    migration.update(cloud);
    return removed;
  }



  template <int dim>
  std::vector<typename ParticleSpacing<dim>::Edge>
  ParticleSpacing<dim>::find_insertions(const ParticleCloud<dim> &cloud, const std::vector<Edge> &edges,
                                        const std::vector<bool> &removed,
                                        const Migration<dim> &migration) const
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
    std::vector<unsigned int> first(cloud.size(), candidates.size());
    for (unsigned int c = candidates.size(); c-- > 0;)
      first[candidates[c].second.first] = first[candidates[c].second.second] = c;
    std::vector<Edge> divided;
    for (unsigned int c = 0; c < candidates.size(); ++c)
      if (const Edge &edge = candidates[c].second; first[edge.first] == c && first[edge.second] == c)
        divided.push_back(edge);
    std::sort(divided.begin(), divided.end());
    if (migration.is_alone())
      return divided;

    // The number of the other end by the first one, as its owner sees it.
    std::vector<double> other(cloud.size(), -1.);
    for (const auto &[a, b] : divided)
      other[a] = cloud.number[b];
    migration.update(other);
    divided.clear();
    for (unsigned int a = 0; a < cloud.size(); ++a)
      if (other[a] >= 0.)
        if (const unsigned int b = cloud.find(static_cast<std::uint64_t>(other[a])); b < cloud.size())
          divided.emplace_back(a, b);
    return divided;
  }



  template <int dim>
  void ParticleSpacing<dim>::insert(const std::vector<Edge> &edges, const Migration<dim> &migration,
                                    ParticleCloud<dim> &cloud) const
  {
    if (migration.is_alone())
    {
      for (const auto &[a, b] : edges)
        cloud.append_midpoint(a, b);
      return;
    }
    // The new particles' numbers follow those of their first parents.
    std::vector<std::uint64_t> own, parents;
    for (const auto &[a, b] : edges)
      if (cloud.is_own(a))
        own.push_back(cloud.number[a]);
    for (const auto &of_rank : Utilities::MPI::all_gather(migration.communicator(), own))
      parents.insert(parents.end(), of_rank.begin(), of_rank.end());
    std::sort(parents.begin(), parents.end());
    const std::uint64_t first = cloud.next_number;
    for (const auto &[a, b] : edges)
    {
      const unsigned int i = cloud.append_midpoint(a, b);
      cloud.number[i]      = first + (std::lower_bound(parents.begin(), parents.end(), cloud.number[a]) -
                                 parents.begin());
    }
    cloud.next_number = first + parents.size();
  }



  template <int dim>
  void ParticleSpacing<dim>::adapt(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                   const FluidMesh<dim> &mesh, OldDomain<dim> &old_domain,
                                   Migration<dim> &migration) const
  {
    const std::vector<Edge> edges    = edges_of<dim>(mesh, cloud.size());
    std::vector<bool> removed        = find_removals(cloud, walls, mesh, edges, migration);
    const std::vector<Edge> inserted = find_insertions(cloud, edges, removed, migration);
    if (migration.is_alone() && inserted.empty() &&
        std::find(removed.begin(), removed.end(), true) == removed.end())
      return;

    const unsigned int n_old = cloud.size();
    insert(inserted, migration, cloud);
    removed.resize(cloud.size(), false);
    std::vector<unsigned int> new_index = cloud.remove(removed);
    new_index.resize(n_old);
    old_domain.renumber(new_index, inserted, cloud.size());
    migration.reinit(cloud);
  }



  template class ParticleSpacing<2>;
  template class ParticleSpacing<3>;
} // namespace Lahar
