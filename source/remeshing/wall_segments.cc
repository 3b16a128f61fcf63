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
    const auto add = [&](const unsigned int i, const unsigned int j) {
      const double length = cloud.position[i].distance(cloud.position[j]);
      if (length > 0. && length < reach &&
          walls.crossed(cloud.position[i], cloud.position[j], 0., 0.).empty())
        segments.push_back({{i, j}});
    };
    for (auto &sides : rows)
      for (auto &row : sides)
      {
        std::sort(row.begin(), row.end());
        for (unsigned int k = 0; k + 1 < row.size(); ++k)
          add(row[k].second, row[k + 1].second);
      }
    // Over the joints of facets: from the last particle on the one to the first on the other, on the same side of both.
    for (unsigned int f = 0; f < n_facets; ++f)
      if (is_wet[f][0] && is_wet[f][1])
        for (unsigned int end = 0; end < 2; ++end)
        {
          const Point<2> &joint  = walls.facets()[f].corners[end];
          const double tolerance = 1e-9 * walls.facets()[f].corners[0].distance(walls.facets()[f].corners[1]);
          for (const unsigned int g : walls.near(joint, tolerance))
            for (unsigned int other_end = 0; other_end < 2; ++other_end)
              if (g > f && joint.distance(walls.facets()[g].corners[other_end]) < tolerance)
                for (unsigned int side = 0; side < 2; ++side)
                {
                  const auto &here  = rows[f][side];
                  const auto &there = rows[g][end == other_end ? 1 - side : side];
                  if (!here.empty() && !there.empty())
                    add((end == 0 ? here.front() : here.back()).second,
                        (other_end == 0 ? there.front() : there.back()).second);
                }
        }
    return segments;
  }
} // namespace Lahar
