// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/interface_faces.h>
#include <lahar/remeshing/merged_place.h>
#include <lahar/remeshing/owed_volume.h>
#include <lahar/remeshing/particle_spacing.h>
#include <lahar/remeshing/surface_chain.h>
#include <lahar/remeshing/wall_faces.h>
#include <lahar/utilities/in_buckets.h>

#include <algorithm>
#include <array>

namespace Lahar
{
  namespace
  {
    /// A fluid particle this near to a wall particle, over the shortest edge, gives way even on the free surface; so does a
    /// particle of the free surface or of a wall to one on an interface, and of two sheets of interfaces one to the other;
    /// and in the plane of one that has landed and one of the free surface the first at a bed, the other one at its rim.
    constexpr double surface_to_wall = 0.3;

    /// What is on an interface is above all that is not.
    template <int dim>
    constexpr unsigned int interface_rank = 2 * (dim + 1);

    /// Two merged particles lie no farther than this times h from the middle between them.
    constexpr double farthest_merged = 0.5;

    /// A particle nearer than this times h to a wall that carries particles gives way.
    constexpr double smallest_gap = 0.1;

    template <int dim>
    bool is_at_wall(const Point<dim> &position, const double h, const Walls<dim> &walls)
    {
      for (const unsigned int facet : walls.near(position, smallest_gap * h))
        if (!walls.facets()[facet].lands &&
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
      const auto for_each = [&mesh](const auto &visit) {
        for (const Simplex<dim> &cell : mesh.particle_cells())
          for (unsigned int a = 0; a <= dim; ++a)
            for (unsigned int b = a + 1; b <= dim; ++b)
              visit(std::min(cell[a], cell[b]), std::max(cell[a], cell[b]));
      };
      std::vector<Edge> edges;
      in_buckets(n_particles, for_each, [&edges](const unsigned int i, std::vector<unsigned int> &others) {
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        for (const unsigned int other : others)
          edges.emplace_back(i, other);
      });
      return edges;
    }

    /// Whether a point lies in the smallest ball with the face's corners on its surface (one through all of them).
    template <int dim>
    bool is_in_smallest_ball(const std::array<unsigned int, dim> &face, const Point<dim> &point,
                             const ParticleCloud<dim> &cloud)
    {
      const Tensor<1, dim> a   = cloud.position[face[1]] - cloud.position[face[0]];
      Tensor<1, dim> to_centre = 0.5 * a;
      if constexpr (dim == 3)
      {
        const Tensor<1, 3> b      = cloud.position[face[2]] - cloud.position[face[0]],
                           normal = cross_product_3d(a, b);
        if (!(normal.norm_square() > 0.))
          return false;
        to_centre = (a.norm_square() * cross_product_3d(b, normal) +
                     b.norm_square() * cross_product_3d(normal, a)) /
                    (2. * normal.norm_square());
      }
      return (point - cloud.position[face[0]] - to_centre).norm_square() < to_centre.norm_square();
    }
  } // namespace



  template <int dim>
  void ParticleSpacing<dim>::declare_parameters(Parameters &prm)
  {
    prm.enter_subsection("Particle spacing");
    prm.declare_number("Shortest edge", "0.6",
                       "Edges shorter than this times the spacing lose a particle. From 0 to 0.9.", 0., 0.9);
    prm.declare_number(
      "Longest edge", "1.5",
      "Edges longer than this times the spacing get a particle in their middle. From 1.3 to 10.", 1.3, 10.);
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
  std::vector<typename ParticleSpacing<dim>::Removal> ParticleSpacing<dim>::find_candidates(
    const ParticleCloud<dim> &cloud, const Walls<dim> &walls, const std::vector<Edge> &short_edges,
    const std::vector<unsigned int> &rank, const std::array<SurfaceChain, 2> &chains,
    const Changes &changes) const
  {
    constexpr unsigned int first = interface_rank<dim>;
    std::vector<Removal> result;
    for (const Edge &edge : short_edges)
    {
      const auto [a, b] = edge;
      if (changes.removed[a] + changes.removed[b] + changes.merged[a] + changes.merged[b] > 0.)
        continue;
      const double h            = 0.5 * (cloud.spacing[a] + cloud.spacing[b]);
      const double length       = cloud.position[a].distance(cloud.position[b]) / h;
      const unsigned int inside = rank[a] < rank[b] ? a : b;
      if (cloud.kind[a] != cloud.kind[b]) // fluid and wall or solid
      {
        const unsigned int fluid = cloud.kind[a] == ParticleKind::fluid ? a : b;
        if (rank[fluid] == 0 || length < surface_to_wall * shortest)
          result.push_back({fluid, {}, {}, {}});
      }
      else if ((rank[a] >= first) != (rank[b] >= first) && rank[inside] > 0)
      {
        if (length < surface_to_wall * shortest)
          result.push_back({inside, {}, {inside == a ? b : a}, {}});
      }
      else if (dim == 2 && rank[inside] > 0 && rank[inside] < first &&
               cloud.in_contact(a) != cloud.in_contact(b) && length >= surface_to_wall * shortest)
        continue;
      else if (rank[a] != rank[b] || rank[b] == 0 || (dim == 3 && rank[b] == first) ||
               (rank[b] % first > 0 && rank[b] % first <= dim && are_on_one_surface(a, b, cloud, walls)))
        result.push_back({inside, {}, {inside == a ? b : a}, {}});
      else if constexpr (dim == 2)
        if (rank[b] % first == dim + 1 || rank[b] == first)
        {
          const std::vector<unsigned int> chain = chains[rank[b] == first ? 1 : 0].around(edge,
                                                                                          changes.removed);
          std::array<Point<2>, 4> places;
          for (unsigned int k = 0; k < chain.size(); ++k)
            places[k] = cloud.position[chain[k]];
          Point<2> place;
          if (!chain.empty() && find_merged_place(places, farthest_merged * cloud.spacing[chain[1]], place))
            result.push_back({b, {a}, {chain[0], chain[3]}, place});
          else if (rank[b] >= first && length < surface_to_wall * shortest)
            result.push_back({b, {}, {a}, {}});
        }
    }
    return result;
  }



  template <int dim>
  std::vector<bool> ParticleSpacing<dim>::find_removals(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                                        const FluidMesh<dim> &mesh,
                                                        const std::vector<Edge> &edges,
                                                        const Migration<dim> &migration) const
  {
    const unsigned int n = cloud.size();
    // What holds the shape of the domain stays before what lies inside it: contacts with walls, the free surface.
    std::vector<unsigned int> rank(n);
    std::vector<bool> on_surface(n, false);
    for (const BoundaryFace &face : free_surface_faces(mesh, cloud, walls))
      for (unsigned int c = 0; c <= dim; ++c)
        if (c != face.opposite)
          on_surface[mesh.particle_cells()[face.cell][c]] = true;
    for (unsigned int i = 0; i < n; ++i)
    {
      rank[i] = on_surface[i] ? dim + 1 : 0;
      for (const int facet : cloud.contact_facets[i])
        rank[i] += (facet != ParticleCloud<dim>::no_facet);
      if (cloud.kind[i] == ParticleKind::fluid && has_several(cloud.part[i]))
        rank[i] += interface_rank<dim>;
    }
    const std::vector<InterfaceFace<dim>> interfaces = find_interface_faces(mesh);
    Changes changes{std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
    // What goes hands its volume on to a fluid particle that is not at the wall itself; drops without one stay.
    std::vector<double> at_wall(n, 0.);
    for (const unsigned int i : mesh.particles())
      at_wall[i] = cloud.kind[i] != ParticleKind::fluid ||
                   is_at_wall(cloud.position[i], cloud.spacing[i], walls);
    std::vector<double> has_heir(n, 0.);
    for (const auto &[a, b] : edges)
    {
      has_heir[a] = std::max(has_heir[a], 1. - at_wall[b]);
      has_heir[b] = std::max(has_heir[b], 1. - at_wall[a]);
    }
    for (const unsigned int i : mesh.particles())
      if (cloud.kind[i] == ParticleKind::fluid && at_wall[i] * has_heir[i] > 0.)
        changes.removed[i] = 1.;
    for (const InterfaceFace<dim> &face : interfaces)
      for (const unsigned int i : face.opposite)
        if (cloud.kind[i] == ParticleKind::fluid && rank[i] == 0 && has_heir[i] > 0. &&
            is_in_smallest_ball<dim>(face.corners, cloud.position[i], cloud))
          changes.removed[i] = 1.;
    migration.update(has_heir);
    migration.update(changes.removed);

    std::vector<Edge> short_edges;
    for (const auto &[a, b] : edges)
      if (((cloud.kind[a] == ParticleKind::fluid && has_heir[a] > 0.) ||
           (cloud.kind[b] == ParticleKind::fluid && has_heir[b] > 0.)) &&
          cloud.position[a].distance(cloud.position[b]) <
            0.5 * shortest * (cloud.spacing[a] + cloud.spacing[b]))
        short_edges.emplace_back(a, b);

    const std::array<SurfaceChain, 2> chains = {{SurfaceChain(mesh, n), SurfaceChain(interfaces, n)}};
    for (bool any_news = true; any_news;)
    {
      // The first removals that change each particle, and that need it as it is.
      const std::vector<Removal> removals = find_candidates(cloud, walls, short_edges, rank, chains, changes);
      std::vector<unsigned int> changed_by(n, removals.size()), needed_by = changed_by;
      for (unsigned int r = removals.size(); r-- > 0;)
      {
        changed_by[removals[r].removed] = r;
        for (const unsigned int i : removals[r].moved)
          changed_by[i] = r;
        for (const unsigned int i : removals[r].needed)
          needed_by[i] = r;
      }
      std::vector<unsigned int> news(2, 0); // whether own particles were changed, and any moved
      for (unsigned int r = 0; r < removals.size(); ++r)
      {
        const Removal &removal    = removals[r];
        const unsigned int b      = removal.removed;
        const auto has_first_word = [&](const unsigned int i) {
          return changed_by[i] == r && needed_by[i] > r;
        };
        if (!has_first_word(b) || !std::all_of(removal.moved.begin(), removal.moved.end(), has_first_word) ||
            !std::all_of(removal.needed.begin(), removal.needed.end(),
                         [&](const unsigned int i) { return changed_by[i] > r; }))
          continue;
        changes.removed[b] = 1.;
        if (cloud.is_own(b) || std::any_of(removal.moved.begin(), removal.moved.end(),
                                           [&](const unsigned int i) { return cloud.is_own(i); }))
          news[0] = 1;
        if (!removal.moved.empty())
          news[1] = 1;
        // The particle of one fluid stands for that of another one, too.
        for (const std::vector<unsigned int> *left : {&removal.moved, &removal.needed})
          if (left->size() == 1 && cloud.kind[left->front()] == ParticleKind::fluid &&
              cloud.kind[b] == ParticleKind::fluid && are_apart(cloud.part[left->front()], cloud.part[b]))
          {
            cloud.part[left->front()] |= cloud.part[b];
            for (std::vector<double> &of_fluid : cloud.structure)
              if (of_fluid[left->front()] < 0.)
                of_fluid[left->front()] = of_fluid[b];
          }
        for (const unsigned int a : removal.moved)
        {
          changes.merged[a]                 = 1.;
          cloud.position[a]                 = removal.place;
          cloud.velocity[a]                 = 0.5 * (cloud.velocity[a] + cloud.velocity[b]);
          cloud.acceleration[a]             = 0.5 * (cloud.acceleration[a] + cloud.acceleration[b]);
          cloud.algorithmic_acceleration[a] = 0.5 * (cloud.algorithmic_acceleration[a] +
                                                     cloud.algorithmic_acceleration[b]);
          cloud.pressure[a]                 = 0.5 * (cloud.pressure[a] + cloud.pressure[b]);
          cloud.pressure_rate[a]            = 0.5 * (cloud.pressure_rate[a] + cloud.pressure_rate[b]);
          cloud.set_mean_structure(a, a, b);
        }
      }
      // What this rank thinks of others' particles may be wrong at the rim of its region: their owners know.
      if (!migration.is_alone())
      {
        Utilities::MPI::max(news, migration.communicator(), news);
        migration.update(changes.removed);
        migration.update(changes.merged);
        if (news[1] > 0)
          migration.update(cloud);
      }
      any_news = news[0] > 0;
    }
    std::vector<bool> removed;
    for (const double flag : changes.removed)
      removed.push_back(flag > 0.);
    return removed;
  }



  template <int dim>
  bool ParticleSpacing<dim>::adapt(ParticleCloud<dim> &cloud, const Walls<dim> &walls,
                                   const FluidMesh<dim> &mesh, OldDomain<dim> &old_domain,
                                   Migration<dim> &migration) const
  {
    const std::vector<Edge> edges = edges_of<dim>(mesh, cloud.size());
    std::vector<bool> removed     = find_removals(cloud, walls, mesh, edges, migration);
    std::vector<Edge> inserted    = find_insertions(cloud, walls, mesh, edges, removed, migration);

    // What a wall, a solid or a particle that goes owes is handed on to the first fluid particle next to it that stays,
    // else to a wall or solid.
    for (const bool to_fluid : {true, false})
      hand_on_owed_volume<dim>(edges, migration, cloud, [&](const unsigned int from, const unsigned int to) {
        return (removed[from] || (to_fluid && cloud.kind[from] != ParticleKind::fluid)) && !removed[to] &&
               (cloud.kind[to] == ParticleKind::fluid || !to_fluid);
      });

    bool any = !inserted.empty() || std::find(removed.begin(), removed.end(), true) != removed.end();
    if (migration.is_alone() && !any)
      return false;

    const unsigned int n_old = cloud.size();
    insert(inserted, mesh, migration, cloud);
    for (unsigned int i = n_old; i < cloud.size(); ++i)
      touch_plane_wall(i, inserted[i - n_old], walls, cloud);
    removed.resize(cloud.size(), false);
    std::vector<unsigned int> new_index = cloud.remove(removed);
    new_index.resize(n_old);
    old_domain.renumber(new_index, inserted, cloud.size());
    migration.reinit(cloud);
    return migration.is_alone() || Utilities::MPI::max(any ? 1U : 0U, migration.communicator()) == 1U;
  }



  template class ParticleSpacing<2>;
  template class ParticleSpacing<3>;
} // namespace Lahar
