// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/wall_segments.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  std::vector<std::array<unsigned int, 2>> find_wall_segments(const ParticleCloud<2> &cloud,
                                                              const Walls<2> &walls, const double reach)
  {
    const unsigned int n_facets = walls.facets().size();
    std::vector<std::array<bool, 2>> is_wet(n_facets, {{false, false}}); // by facet and side
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.kind[i] == ParticleKind::fluid)
        for (const unsigned int f : walls.near(cloud.position[i], cloud.spacing[i]))
          if (walls.is_above(f, cloud.position[i], 0.))
            if (const double height = walls.signed_distance(f, cloud.position[i]);
                std::abs(height) < cloud.spacing[i])
              is_wet[f][height > 0.] = true;

    // On each side of a facet the particles by their place along it.
    std::vector<std::array<std::vector<std::pair<double, unsigned int>>, 2>> rows(n_facets);
    for (unsigned int i = 0; i < cloud.size(); ++i)
      for (const int f : cloud.contact_facets[i])
        if (f != ParticleCloud<2>::no_facet && is_wet[f][0] && is_wet[f][1])
        {
          const auto &corners = walls.facets()[f].corners;
          rows[f][walls.signed_distance(f, cloud.position[i]) > 0.].emplace_back(
            (corners[1] - corners[0]) * (cloud.position[i] - corners[0]), i);
        }
    std::vector<std::array<unsigned int, 2>> segments;
    for (auto &sides : rows)
      for (auto &row : sides)
      {
        std::sort(row.begin(), row.end());
        for (unsigned int k = 0; k + 1 < row.size(); ++k)
        {
          const unsigned int i = row[k].second, j = row[k + 1].second;
          const double length = cloud.position[i].distance(cloud.position[j]);
          if (length > 0. && length < reach &&
              walls.crossed(cloud.position[i], cloud.position[j], 0., 0.).empty())
            segments.push_back({{i, j}});
        }
      }
    return segments;
  }
} // namespace Lahar
