// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/interface_segments.h>

#include <algorithm>
#include <map>

namespace Lahar
{
  namespace
  {
    using Segment = std::array<unsigned int, 2>;

    /// Over h: longer ones would force flat triangles.
    constexpr double longest = 2.;

    /// Segments that come nearer to each other than this part of their lengths count as crossing.
    constexpr double near = 1e-9;

    /// Whether two segments without a common end cross or touch.
    bool cross(const Segment &s, const Segment &t, const ParticleCloud<2> &cloud)
    {
      for (const unsigned int end : s)
        if (end == t[0] || end == t[1])
          return false;
      const auto apart = [&](const Segment &line, const Segment &other) {
        const Tensor<1, 2> along  = cloud.position[line[1]] - cloud.position[line[0]],
                           normal = cross_product_2d(along);
        const double a            = normal * (cloud.position[other[0]] - cloud.position[line[0]]),
                     b            = normal * (cloud.position[other[1]] - cloud.position[line[0]]);
        return std::min(a, b) > near * along.norm_square() || std::max(a, b) < -near * along.norm_square();
      };
      return !apart(s, t) && !apart(t, s);
    }

    /// The @p segments that cross none of their own and none of the @p others.
    std::vector<Segment> without_crossings(const std::vector<Segment> &segments,
                                           const std::vector<Segment> &others, const ParticleCloud<2> &cloud)
    {
      // By where they begin in x; a segment meets those that begin before it ends.
      std::vector<Segment> all = segments;
      all.insert(all.end(), others.begin(), others.end());
      const auto begin = [&](const unsigned int s) {
        return std::min(cloud.position[all[s][0]][0], cloud.position[all[s][1]][0]);
      };
      const auto end = [&](const unsigned int s) {
        return std::max(cloud.position[all[s][0]][0], cloud.position[all[s][1]][0]);
      };
      std::vector<unsigned int> order(all.size());
      for (unsigned int s = 0; s < all.size(); ++s)
        order[s] = s;
      std::sort(order.begin(), order.end(),
                [&](const unsigned int s, const unsigned int t) { return begin(s) < begin(t); });
      std::vector<bool> crossing(all.size(), false);
      for (unsigned int k = 0; k < order.size(); ++k)
        for (unsigned int l = k + 1; l < order.size() && begin(order[l]) <= end(order[k]); ++l)
          if ((order[k] < segments.size() || order[l] < segments.size()) &&
              cross(all[order[k]], all[order[l]], cloud))
            crossing[order[k]] = crossing[order[l]] = true;
      std::vector<Segment> result;
      for (unsigned int s = 0; s < segments.size(); ++s)
        if (!crossing[s])
          result.push_back(segments[s]);
      return result;
    }
  } // namespace



  std::vector<std::array<unsigned int, 2>>
  find_interface_segments(const std::vector<InterfaceFace<2>> &faces, const OldDomain<2> &old_domain,
                          const ParticleCloud<2> &cloud, const double reach,
                          const std::vector<std::array<unsigned int, 2>> &taken)
  {
    std::map<Segment, unsigned int> middle; // of divided edges, by their ends' old indices
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (const auto [a, b] = old_domain.parents(i); a != b)
        middle[{{std::min(a, b), std::max(a, b)}}] = i;

    std::vector<Segment> segments;
    std::map<unsigned int, std::vector<unsigned int>> beside_removed; // ends of edges whose other end is gone
    for (const InterfaceFace<2> &face : faces)
    {
      const auto [a, b]        = face.corners;
      const unsigned int new_a = old_domain.present(a), new_b = old_domain.present(b);
      const auto divided = middle.find({{std::min(a, b), std::max(a, b)}});
      if (new_a < cloud.size() && new_b < cloud.size() && divided != middle.end())
      {
        segments.push_back({{new_a, divided->second}});
        segments.push_back({{divided->second, new_b}});
      }
      else if (new_a < cloud.size() && new_b < cloud.size())
        segments.push_back({{new_a, new_b}});
      else if (new_a < cloud.size())
        beside_removed[b].push_back(new_a);
      else if (new_b < cloud.size())
        beside_removed[a].push_back(new_b);
    }
    for (const auto &[removed, ends] : beside_removed)
      if (ends.size() == 2 && ends[0] != ends[1])
        segments.push_back({{ends[0], ends[1]}});
    segments.erase(std::remove_if(segments.begin(), segments.end(),
                                  [&](const Segment &s) {
                                    const double length = cloud.position[s[0]].distance(cloud.position[s[1]]);
                                    const double h      = 0.5 * (cloud.spacing[s[0]] + cloud.spacing[s[1]]);
                                    return !(length > 0. && length < std::min(longest * h, reach));
                                  }),
                   segments.end());
    return without_crossings(segments, taken, cloud);
  }
} // namespace Lahar
