// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/harmful_midpoints.h>
#include <lahar/remeshing/particle_spacing.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  template <int dim>
  std::vector<typename ParticleSpacing<dim>::Edge> ParticleSpacing<dim>::find_insertions(
    const ParticleCloud<dim> &cloud, const Walls<dim> &walls, const FluidMesh<dim> &mesh,
    const std::vector<Edge> &edges, const std::vector<bool> &removed, const Migration<dim> &migration) const
  {
    std::vector<Edge> long_edges;
    for (const Edge &edge : edges)
    {
      const auto [a, b] = edge;
      if (removed[a] || removed[b] ||
          (cloud.kind[a] != ParticleKind::fluid && cloud.kind[b] != ParticleKind::fluid))
        continue;
      const double h      = 0.5 * (cloud.spacing[a] + cloud.spacing[b]);
      const double length = cloud.position[a].distance(cloud.position[b]);
      // Where two fluids meet, a particle of both parts them.
      const bool joins_fluids = cloud.kind[a] == ParticleKind::fluid &&
                                cloud.kind[b] == ParticleKind::fluid &&
                                are_apart(cloud.part[a], cloud.part[b]);
      if (length > longest * h || joins_fluids)
        long_edges.push_back(edge);
    }
    const std::vector<bool> harmful = harmful_midpoints<dim>(long_edges, cloud, walls, mesh, shortest);
    std::vector<std::pair<double, Edge>> candidates;
    for (unsigned int e = 0; e < long_edges.size(); ++e)
      if (!harmful[e])
        candidates.push_back(
          {-cloud.position[long_edges[e].first].distance(cloud.position[long_edges[e].second]),
           long_edges[e]});
    std::sort(candidates.begin(), candidates.end());

    // One division per particle and step: its other long edges may be gone afterwards. Of an edge that is divided each
    // end knows the number of the other one.
    constexpr double none = -1.;
    std::vector<double> other(cloud.size(), none);
    for (bool any = true; any;)
    {
      const auto is_free = [&](const Edge &edge) {
        return other[edge.first] + other[edge.second] == 2. * none;
      };
      std::vector<unsigned int> first(cloud.size(), candidates.size());
      for (unsigned int c = candidates.size(); c-- > 0;)
        if (const Edge &edge = candidates[c].second; is_free(edge))
          first[edge.first] = first[edge.second] = c;
      any = false;
      for (unsigned int c = 0; c < candidates.size(); ++c)
        if (const Edge &edge = candidates[c].second; first[edge.first] == c && first[edge.second] == c)
        {
          other[edge.first]  = cloud.number[edge.second];
          other[edge.second] = cloud.number[edge.first];
          any                = any || cloud.is_own(edge.first) || cloud.is_own(edge.second);
        }
      if (!migration.is_alone())
        any = Utilities::MPI::max(any ? 1U : 0U, migration.communicator()) == 1U;
      migration.update(other);
    }

    std::vector<Edge> divided;
    for (unsigned int a = 0; a < cloud.size(); ++a)
      if (other[a] > cloud.number[a])
        if (const unsigned int b = cloud.find(static_cast<std::uint64_t>(other[a])); b < cloud.size())
          divided.emplace_back(a, b);
    return divided;
  }



  namespace
  {
    using Edge = std::pair<unsigned int, unsigned int>;

    /// The fluids of the cells around each edge.
    template <int dim>
    std::map<Edge, FluidSet> fluids_around(const std::vector<Edge> &edges, const FluidMesh<dim> &mesh)
    {
      std::map<Edge, FluidSet> result;
      for (const Edge &edge : edges)
        result[edge] = 0U;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        for (const unsigned int a : mesh.particle_cells()[c])
          for (const unsigned int b : mesh.particle_cells()[c])
            if (a < b)
              if (const auto edge = result.find({a, b}); edge != result.end())
                edge->second |= fluid_set(mesh.fluid(c));
      return result;
    }
  } // namespace



  template <int dim>
  void ParticleSpacing<dim>::insert(std::vector<Edge> &edges, const FluidMesh<dim> &mesh,
                                    const Migration<dim> &migration, ParticleCloud<dim> &cloud) const
  {
    using Key         = std::pair<double, std::uint64_t>; // the longest first
    const auto key_of = [&](const Edge &edge) {
      return Key(-cloud.position[edge.first].distance(cloud.position[edge.second]), cloud.number[edge.first]);
    };
    std::sort(edges.begin(), edges.end(),
              [&](const Edge &e, const Edge &f) { return key_of(e) < key_of(f); });
    std::vector<Key> keys;
    for (const Edge &edge : edges)
      if (cloud.is_own(edge.first))
        keys.push_back(key_of(edge));
    if (!migration.is_alone())
    {
      const auto of_ranks = Utilities::MPI::all_gather(migration.communicator(), keys);
      keys.clear();
      for (const std::vector<Key> &of_rank : of_ranks)
        keys.insert(keys.end(), of_rank.begin(), of_rank.end());
      std::sort(keys.begin(), keys.end());
    }
    const std::uint64_t first             = cloud.next_number;
    const std::map<Edge, FluidSet> around = several_fluids ? fluids_around(edges, mesh)
                                                           : std::map<Edge, FluidSet>();
    for (const Edge &edge : edges)
    {
      const unsigned int i = cloud.append_midpoint(edge.first, edge.second);
      if (const auto fluids = around.find(edge); fluids != around.end())
        cloud.part[i] = fluids->second | (has_several(cloud.part[i]) &&
                                              are_apart(cloud.part[edge.first], cloud.part[edge.second])
                                            ? cloud.part[i]
                                            : 0U);
      cloud.number[i] = first + (std::lower_bound(keys.begin(), keys.end(), key_of(edge)) - keys.begin());
    }
    cloud.next_number = first + keys.size();
  }



  template std::vector<ParticleSpacing<2>::Edge>
  ParticleSpacing<2>::find_insertions(const ParticleCloud<2> &, const Walls<2> &, const FluidMesh<2> &,
                                      const std::vector<Edge> &, const std::vector<bool> &,
                                      const Migration<2> &) const;
  template void ParticleSpacing<2>::insert(std::vector<Edge> &, const FluidMesh<2> &, const Migration<2> &,
                                           ParticleCloud<2> &) const;
  template std::vector<ParticleSpacing<3>::Edge>
  ParticleSpacing<3>::find_insertions(const ParticleCloud<3> &, const Walls<3> &, const FluidMesh<3> &,
                                      const std::vector<Edge> &, const std::vector<bool> &,
                                      const Migration<3> &) const;
  template void ParticleSpacing<3>::insert(std::vector<Edge> &, const FluidMesh<3> &, const Migration<3> &,
                                           ParticleCloud<3> &) const;
} // namespace Lahar
