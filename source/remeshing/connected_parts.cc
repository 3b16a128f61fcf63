// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/remeshing/connected_parts.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  namespace
  {
    /// The boxes of the other ranks that may know some of this rank's particles: they know what is in their regions,
    /// and the other corners of cells there, which are less than twice the regions' distance away.
    template <int dim>
    std::vector<BoundingBox<dim>> boxes_around(const ParticleCloud<dim> &cloud,
                                               const Migration<dim> &migration)
    {
      std::vector<BoundingBox<dim>> result;
      for (unsigned int r = 0; r < migration.boxes().size(); ++r)
        for (BoundingBox<dim> box : migration.boxes()[r])
          if (box.extend(2. * migration.distance()); r != cloud.rank)
            for (const BoundingBox<dim> &own : migration.boxes()[cloud.rank])
              if (box.get_neighbor_type(own) != NeighborType::not_neighbors)
                result.push_back(box);
      return result;
    }
  } // namespace



  template <int dim>
  ConnectedParts<dim>::ConnectedParts(const unsigned int n_particles)
    : sets(n_particles)
    , label(n_particles)
    , is_shared(n_particles, false)
  {}



  template <int dim>
  void ConnectedParts<dim>::connect(const ParticleCloud<dim> &cloud, const Migration<dim> &migration)
  {
    const unsigned int n                       = cloud.size();
    const std::vector<BoundingBox<dim>> around = boxes_around(cloud, migration);
    std::vector<bool> set_is_shared(n, false);
    for (unsigned int i = 0; i < n; ++i)
    {
      label[i] = cloud.number[i];
      if (!cloud.is_own(i) || std::any_of(around.begin(), around.end(), [&](const BoundingBox<dim> &box) {
            return box.point_inside(cloud.position[i]);
          }))
        set_is_shared[sets.find_set(i)] = true;
    }
    for (unsigned int i = 0; i < n; ++i)
      is_shared[i] = set_is_shared[sets.find_set(i)];

    std::vector<double> of_set(n);
    for (bool any_news = true; any_news;)
    {
      of_set = label;
      for (unsigned int i = 0; i < n; ++i)
      {
        double &smallest = of_set[sets.find_set(i)];
        smallest         = std::min(smallest, label[i]);
      }
      any_news = false;
      for (unsigned int i = 0; i < n; ++i)
        if (const double smallest = of_set[sets.find_set(i)]; smallest < label[i])
        {
          label[i] = smallest;
          any_news = true;
        }
      if (migration.is_alone())
        break;
      any_news = Utilities::MPI::max(any_news ? 1U : 0U, migration.communicator()) == 1U;
      if (any_news)
        migration.update(label);
    }
  }



  template <int dim>
  std::vector<double> ConnectedParts<dim>::sum(const std::vector<double> &contributions,
                                               const Migration<dim> &migration)
  {
    const unsigned int n = contributions.size();
    std::vector<double> of_set(n, 0.), result(n);
    for (unsigned int i = 0; i < n; ++i)
      of_set[sets.find_set(i)] += contributions[i];
    std::map<double, double> shared; // parts that several ranks may know
    if (!migration.is_alone())
    {
      std::map<double, double> own;
      for (unsigned int i = 0; i < n; ++i)
        if (sets.find_set(i) == i && is_shared[i] && of_set[i] != 0.)
          own[label[i]] += of_set[i];
      const std::vector<std::pair<double, double>> own_list(own.begin(), own.end());
      for (const auto &of_rank : Utilities::MPI::all_gather(migration.communicator(), own_list))
        for (const auto &[part, value] : of_rank)
          shared[part] += value;
    }
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto found = is_shared[i] ? shared.find(label[i]) : shared.end();
      result[i] = is_shared[i] ? (found == shared.end() ? 0. : found->second) : of_set[sets.find_set(i)];
    }
    return result;
  }



  template class ConnectedParts<2>;
  template class ConnectedParts<3>;
} // namespace Lahar
