// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/plastic_multipliers.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  void PlasticMultipliers<dim>::set(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                    std::vector<Value> values)
  {
    AssertDimension(values.size(), mesh.n_cells());
    of_cells = std::move(values);
    by_particles.clear();
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      by_particles.add(CellTable<dim>::key(mesh.particle_cells()[c], cloud), of_cells[c]);
    by_particles.sort();
  }



  template <int dim>
  void PlasticMultipliers<dim>::spread(const FluidMesh<dim> &mesh, const unsigned int n_fluids,
                                       const ParticleCloud<dim> &cloud, const Migration<dim> &migration)
  {
    means.assign(n_fluids, {});
    old_fluids.clear();
    if (n_fluids > 1)
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        old_fluids.emplace_back(CellTable<dim>::key(mesh.particle_cells()[c], cloud), mesh.fluid(c));
    std::sort(old_fluids.begin(), old_fluids.end());
    for (unsigned int fluid = 0; fluid < n_fluids; ++fluid)
    {
      // Sums of V Λ and V; doubles side by side, as they are sent.
      constexpr unsigned int n = Value::n_independent_components;
      std::vector<std::array<double, n + 1>> sums(cloud.size(), std::array<double, n + 1>{});
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
      {
        const Simplex<dim> &cell = mesh.particle_cells()[c];
        const Value *value = mesh.fluid(c) == fluid ? by_particles.find(CellTable<dim>::key(cell, cloud))
                                                    : nullptr;
        if (value == nullptr)
          continue;
        const double volume = std::abs(body_volume<dim>(corners_of<dim>(cell, cloud.position)));
        for (const unsigned int particle : cell)
        {
          for (unsigned int i = 0; i < n; ++i)
            sums[particle][i] += volume * value->access_raw_entry(i);
          sums[particle][n] += volume;
        }
      }
      migration.update(sums);
      for (unsigned int particle = 0; particle < cloud.size(); ++particle)
        if (sums[particle][n] > 0.)
        {
          Value mean;
          for (unsigned int i = 0; i < n; ++i)
            mean.access_raw_entry(i) = sums[particle][i] / sums[particle][n];
          means[fluid].emplace_back(cloud.number[particle], mean);
        }
    }
  }



  template <int dim>
  bool PlasticMultipliers<dim>::is_of_other(const typename CellTable<dim>::Key &key,
                                            const unsigned int fluid) const
  {
    const auto place = std::lower_bound(old_fluids.begin(), old_fluids.end(), std::make_pair(key, 0U));
    return place != old_fluids.end() && place->first == key && place->second != fluid;
  }



  template <int dim>
  void PlasticMultipliers<dim>::follow(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud)
  {
    of_cells.assign(mesh.n_cells(), Value());
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const Simplex<dim> &cell = mesh.particle_cells()[c];
      const auto key           = CellTable<dim>::key(cell, cloud);
      if (const Value *value = by_particles.find(key); value != nullptr && !is_of_other(key, mesh.fluid(c)))
      {
        of_cells[c] = *value;
        continue;
      }
      if (mesh.fluid(c) >= means.size())
        continue;
      const auto &of_fluid = means[mesh.fluid(c)];
      unsigned int n_known = 0;
      for (const std::uint64_t number : key)
      {
        const auto place = std::lower_bound(of_fluid.begin(), of_fluid.end(), number,
                                            [](const auto &mean, const std::uint64_t wanted) {
                                              return mean.first < wanted;
                                            });
        if (place != of_fluid.end() && place->first == number)
        {
          of_cells[c] += place->second;
          ++n_known;
        }
      }
      if (n_known > 0)
        of_cells[c] /= n_known;
    }
  }



  template class PlasticMultipliers<2>;
  template class PlasticMultipliers<3>;
} // namespace Lahar
