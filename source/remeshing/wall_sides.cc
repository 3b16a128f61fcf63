// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/point_tree.h>
#include <lahar/remeshing/wall_sides.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Lahar
{
  namespace
  {
    /// A particle nearer to a facet's plane than this times its spacing lies on it, on no side.
    constexpr double on_plane = 0.1 * contact_offset;

    /// Facets meet where they are nearer than this times their size.
    constexpr double joint_tolerance = 1e-9;

    /// The rim of a facet counts this times the spacing wider.
    constexpr double facet_rim = 1e-3;
  } // namespace



  WallSides::WallSides(const ParticleCloud<3> &cloud, const Walls<3> &walls, const double distance)
    : cloud(cloud)
    , walls(walls)
    , all_sides(cloud.size())
  {
    const std::vector<unsigned int> thin_facets = find_thin_facets();
    if (thin_facets.empty())
      return;
    find_sheets(thin_facets);
    find_sides(distance);
  }



  std::vector<unsigned int> WallSides::find_thin_facets() const
  {
    std::vector<std::array<bool, 2>> is_wet(walls.facets().size(), {{false, false}});
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.kind[i] == ParticleKind::fluid)
        for (const unsigned int f : walls.near(cloud.position[i], cloud.spacing[i]))
          if (walls.facets()[f].lands && walls.is_above(f, cloud.position[i], 0.))
            if (const double height = walls.signed_distance(f, cloud.position[i]);
                std::abs(height) < cloud.spacing[i])
              is_wet[f][height > 0.] = true;
    std::vector<unsigned int> result;
    for (unsigned int f = 0; f < is_wet.size(); ++f)
      if (is_wet[f][0] && is_wet[f][1])
        result.push_back(f);
    return result;
  }



  bool WallSides::goes_on(const unsigned int from, const unsigned int to) const
  {
    if (std::abs(walls.normal(from) * walls.normal(to)) <= smooth_joint)
      return false;
    const auto &a          = walls.facets()[from].corners;
    const auto &b          = walls.facets()[to].corners;
    const double tolerance = joint_tolerance * (a[0].distance(a[1]) + a[1].distance(a[2]));
    const bool meet        = std::any_of(b.begin(), b.end(), [&](const Point<3> &corner) {
      return nearest_point<3>(a, corner).distance(corner) < tolerance;
    });
    // What is folded back lies above the other one.
    const auto is_folded = [&](const unsigned int facet, const std::array<Point<3>, 3> &corners) {
      const Point<3> middle = corners[0] + ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3.;
      return walls.is_above(facet, middle, 0.) && std::abs(walls.signed_distance(facet, middle)) > tolerance;
    };
    return meet && !is_folded(from, b) && !is_folded(to, a);
  }



  void WallSides::find_sheets(const std::vector<unsigned int> &thin_facets)
  {
    sheets.assign(walls.facets().size(), numbers::invalid_unsigned_int);
    directions.assign(walls.facets().size(), 1);
    std::vector<bool> is_thin(walls.facets().size(), false);
    for (const unsigned int f : thin_facets)
      is_thin[f] = true;
    for (const unsigned int first : thin_facets)
    {
      if (sheets[first] != numbers::invalid_unsigned_int)
        continue;
      sheets[first]                   = n_sheets;
      std::vector<unsigned int> front = {first};
      while (!front.empty())
      {
        const unsigned int f = front.back();
        front.pop_back();
        const auto &corners = walls.facets()[f].corners;
        const double size   = std::max(corners[0].distance(corners[1]), corners[0].distance(corners[2]));
        for (const unsigned int g : walls.near(corners[0], (1. + joint_tolerance) * size))
          if (is_thin[g] && sheets[g] == numbers::invalid_unsigned_int && (goes_on(f, g) || goes_on(g, f)))
          {
            sheets[g]     = n_sheets;
            directions[g] = directions[f] * (walls.normal(f) * walls.normal(g) > 0. ? 1 : -1);
            front.push_back(g);
          }
      }
      ++n_sheets;
    }
  }



  void WallSides::find_sides(const double distance)
  {
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      const Point<3> &position = cloud.position[i];
      std::vector<unsigned int> near;
      for (const unsigned int f : walls.near(position, distance))
        if (sheets[f] != numbers::invalid_unsigned_int)
          near.push_back(f);
      if (near.empty())
        continue;
      all_sides[i].assign(n_sheets, 0);
      std::vector<double> nearest(n_sheets, distance);
      for (const unsigned int f : near)
      {
        const Point<3> place = nearest_point<3>(walls.facets()[f].corners, position);
        const double gap = place.distance(position), height = walls.signed_distance(f, position);
        if (gap >= nearest[sheets[f]])
          continue;
        nearest[sheets[f]]  = gap;
        const bool on_joint = std::any_of(near.begin(), near.end(), [&](const unsigned int g) {
          return g != f && sheets[g] == sheets[f] &&
                 nearest_point<3>(walls.facets()[g].corners, place).distance(place) <
                   facet_rim * cloud.spacing[i];
        });
        const bool has_side = std::abs(height) > on_plane * cloud.spacing[i] &&
                              (on_joint || walls.is_above(f, position, facet_rim * cloud.spacing[i]));
        all_sides[i][sheets[f]] = !has_side ? 0 : height > 0. ? directions[f] : -directions[f];
      }
    }
  }



  bool WallSides::are_together(const std::vector<signed char> &a, const std::vector<signed char> &b)
  {
    for (unsigned int k = 0; k < std::min(a.size(), b.size()); ++k)
      if (a[k] * b[k] < 0)
        return false;
    return true;
  }



  bool WallSides::hides(const Point<3> &from, const Point<3> &point) const
  {
    const std::vector<unsigned int> between = walls.crossed(from, point, 0., 0.);
    return std::any_of(between.begin(), between.end(),
                       [&](const unsigned int facet) { return walls.facets()[facet].lands; });
  }



  bool WallSides::parts(const Simplex<3> &simplex) const
  {
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int b = 0; b < a; ++b)
        if (!are_together(all_sides[simplex[a]], all_sides[simplex[b]]) &&
            hides(cloud.position[simplex[a]], cloud.position[simplex[b]]))
          return true;
    return false;
  }



  void part_sides_of_walls(const ParticleCloud<3> &cloud, const Walls<3> &walls, const double reach,
                           const std::function<bool(const Simplex<3> &)> &matters,
                           std::vector<Simplex<3>> &simplices)
  {
    // The ball of what comes passes through a wall, and no corner is farther from that than its diameter.
    const double largest_radius = 0.5 * reach;
    const WallSides sides(cloud, walls, 2. * largest_radius);
    if (sides.empty())
      return;
    std::set<std::vector<signed char>> combinations;
    std::vector<unsigned int> near;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (const auto &here = sides.sides(i); !here.empty())
      {
        near.push_back(i);
        if (cloud.is_own(i) &&
            std::any_of(here.begin(), here.end(), [](const int side) { return side != 0; }))
          combinations.insert(here);
      }

    std::vector<Simplex<3>> found;
    for (const std::vector<signed char> &combination : combinations)
    {
      std::vector<unsigned int> here, hidden;
      for (const unsigned int i : near)
        (WallSides::are_together(combination, sides.sides(i)) ? here : hidden).push_back(i);
      if (hidden.empty())
        continue;
      DelaunayTriangulation<3> triangulation(cloud.position);
      triangulation.insert(here);
      const PointTree<3> hidden_points(cloud.position, hidden);
      for (const Simplex<3> &simplex : triangulation.simplices())
      {
        const Simplex<3> candidate = canonical<3>(simplex);
        if (!matters(candidate))
          continue;
        const auto corners            = corners_of<3>(candidate, cloud.position);
        const Tensor<1, 3> from_first = to_circumcentre<3>(corners);
        const double radius           = from_first.norm();
        if (!(radius < largest_radius))
          continue;
        const Point<3> centre = centroid<3>(corners);
        const auto in_ball    = [&](const std::function<bool(const unsigned int)> &counts) {
          return hidden_points.nearest_in_ball(centre, corners[0] + from_first, (1. + 1e-6) * radius,
                                                  counts) != numbers::invalid_unsigned_int;
        };
        const auto contradicts = [&](const unsigned int i) {
          return in_circumball<3>(corners, cloud.position[i]);
        };
        if (in_ball(contradicts) && !in_ball([&](const unsigned int i) {
              return contradicts(i) && !sides.hides(centre, cloud.position[i]);
            }))
          found.push_back(candidate);
      }
    }
    simplices.insert(simplices.end(), found.begin(), found.end());
    simplices.erase(std::remove_if(simplices.begin(), simplices.end(),
                                   [&](const Simplex<3> &simplex) { return sides.parts(simplex); }),
                    simplices.end());
    std::sort(simplices.begin(), simplices.end());
    simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  }
} // namespace Lahar
