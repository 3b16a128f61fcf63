// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_owed_volume_h
#define lahar_remeshing_owed_volume_h

#include <lahar/remeshing/migration.h>

#include <utility>
#include <vector>

namespace Lahar
{
  /**
   * Let each particle hand what it owes (ParticleCloud::owed_volume) on to the first of its neighbours that is an heir of
   * it: the one with the smallest number. The owner of a particle chooses, for other ranks may not know all of its
   * neighbours, and two would choose differently. Collective.
   *
   * @param edges between neighbours, each once: all of own particles, and of copies those to own ones at least.
   * @param is_heir whether the second particle is an heir of the first one; no heir has heirs.
   */
  template <int dim, typename IsHeir>
  void hand_on_owed_volume(const std::vector<std::pair<unsigned int, unsigned int>> &edges,
                           const Migration<dim> &migration, ParticleCloud<dim> &cloud, const IsHeir &is_heir)
  {
    constexpr double none = -1.;
    std::vector<double> heir(cloud.size(), none);
    const auto for_both_ways = [&](const auto &action) {
      for (const auto &[a, b] : edges)
      {
        action(a, b);
        action(b, a);
      }
    };
    for_both_ways([&](const unsigned int from, const unsigned int to) {
      const double number = cloud.number[to];
      if (cloud.is_own(from) && is_heir(from, to) && (heir[from] == none || number < heir[from]))
        heir[from] = number;
    });
    migration.update(heir);
    for_both_ways([&](const unsigned int from, const unsigned int to) {
      if (heir[from] == static_cast<double>(cloud.number[to]))
        cloud.owed_volume[to] += cloud.owed_volume[from];
    });
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (heir[i] != none)
        cloud.owed_volume[i] = 0.;
    migration.update(cloud.owed_volume);
  }
} // namespace Lahar

#endif
