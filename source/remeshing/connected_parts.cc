#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/remeshing/connected_parts.h>

#include <map>

namespace Lahar
{
  template <int dim>
  ConnectedParts<dim>::ConnectedParts(const unsigned int n_particles)
    : sets(n_particles)
    , label(n_particles)
    , is_foreign(n_particles, false)
  {}



  template <int dim>
  void ConnectedParts<dim>::connect(const ParticleCloud<dim> &cloud, const Migration<dim> &migration)
  {
    const unsigned int n = cloud.size();
    std::vector<bool> set_is_foreign(n, false);
    for (unsigned int i = 0; i < n; ++i)
    {
      label[i] = cloud.number[i];
      if (!cloud.is_own(i))
        set_is_foreign[sets.find_set(i)] = true;
    }
    for (unsigned int i = 0; i < n; ++i)
      is_foreign[i] = set_is_foreign[sets.find_set(i)];

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
    std::map<double, double> shared; // parts of several ranks
    if (!migration.is_alone())
    {
      std::map<double, double> own;
      for (unsigned int i = 0; i < n; ++i)
        if (sets.find_set(i) == i && is_foreign[i] && of_set[i] != 0.)
          own[label[i]] += of_set[i];
      const std::vector<std::pair<double, double>> own_list(own.begin(), own.end());
      for (const auto &of_rank : Utilities::MPI::all_gather(migration.communicator(), own_list))
        for (const auto &[part, value] : of_rank)
          shared[part] += value;
    }
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto found = is_foreign[i] ? shared.find(label[i]) : shared.end();
      result[i] = is_foreign[i] ? (found == shared.end() ? 0. : found->second) : of_set[sets.find_set(i)];
    }
    return result;
  }



  template class ConnectedParts<2>;
  template class ConnectedParts<3>;
} // namespace Lahar
