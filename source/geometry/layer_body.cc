// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/lattice.h>
#include <lahar/geometry/layer_body.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/polygon.h>
#include <lahar/geometry/simplex_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Lahar
{
  namespace
  {
    /// Of lengths, as a part of the pieces' size.
    constexpr double rounding = 1e-7;

    /// Of the ground's edges, how far chords of them may lie off.
    constexpr double chord = 0.15;

    double plan_area(const Point<3> &a, const Point<3> &b, const Point<3> &c)
    {
      return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }

    double plan_size(const GroundPiece &piece)
    {
      return std::sqrt(std::abs(plan_area(piece[0].place, piece[1].place, piece[2].place)));
    }
  } // namespace



  std::vector<GroundPiece> positive_part(const GroundPiece &piece, const std::array<double, 3> &values,
                                         const double tolerance)
  {
    std::vector<GroundPoint> part;
    bool any = false;
    for (unsigned int v = 0; v < 3; ++v)
    {
      const unsigned int next = (v + 1) % 3;
      const double here = values[v], there = values[next];
      any = any || here > tolerance;
      if (here > -tolerance)
        part.push_back(piece[v]);
      if ((here > tolerance && there < -tolerance) || (here < -tolerance && there > tolerance))
      {
        const double share = here / (here - there);
        part.push_back({piece[v].place + share * (piece[next].place - piece[v].place),
                        piece[v].depth + share * (piece[next].depth - piece[v].depth)});
      }
    }
    std::vector<GroundPiece> result;
    for (unsigned int i = 2; i < part.size() && any; ++i)
    {
      result.push_back({{part[0], part[i - 1], part[i]}});
      if (!(plan_size(result.back()) > 1e-2 * rounding * plan_size(piece)))
        result.pop_back();
    }
    return result;
  }



  LayerBody::Ground::Ground(const std::vector<GroundPiece> &pieces)
  {
    double size = 0.;
    for (const GroundPiece &piece : pieces)
      size = std::max(size, plan_size(piece));
    PointSet<2> places;
    for (const GroundPiece &piece : pieces)
    {
      Simplex<2> &triangle = triangles.emplace_back();
      for (unsigned int v = 0; v < 3; ++v)
      {
        const Point<2> p(piece[v].place[0], piece[v].place[1]);
        const std::vector<unsigned int> known = places.near(p, rounding * size);
        triangle[v]                           = known.empty() ? nodes.size() : known[0];
        if (!known.empty())
          continue;
        places.insert(p);
        plan.push_back(p);
        nodes.push_back(piece[v]);
        if (!(nodes.back().depth > rounding * size))
          nodes.back().depth = 0.;
      }
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        triangles.pop_back();
    }
  }



  std::vector<Point<3>> LayerBody::Ground::prism_nodes() const
  {
    std::vector<Point<3>> result;
    for (const GroundPoint &node : nodes)
      result.push_back(node.place);
    for (const GroundPoint &node : nodes)
      result.push_back(node.place + Point<3>(0., 0., node.depth));
    return result;
  }



  std::vector<Simplex<3>> LayerBody::Ground::prisms() const
  {
    // The diagonals of the side of two columns rise from that with the smaller number: neighbours agree.
    std::vector<Simplex<3>> result;
    for (Simplex<2> base : triangles)
    {
      std::sort(base.begin(), base.end());
      Simplex<2> top = base;
      for (unsigned int v = 0; v < 3; ++v)
        if (nodes[base[v]].depth > 0.)
          top[v] += nodes.size();
      for (unsigned int v = 0; v < 3; ++v)
        if (top[v] != base[v])
        {
          Simplex<3> &simplex = result.emplace_back();
          for (unsigned int i = 0; i < 4; ++i)
            simplex[i] = i <= v ? base[i] : top[i - 1];
        }
    }
    return result;
  }



  LayerBody::LayerBody(const std::string &name, const std::vector<GroundPiece> &pieces)
    : LayerBody(name, Ground(pieces))
  {}



  LayerBody::LayerBody(const std::string &name, const Ground &ground)
    : MeshBody<3>(name, ground.prism_nodes(), ground.prisms())
    , ground(ground)
    , plan(name, ground.plan, ground.triangles)
  {
    double area = 0., in_plan = 0.;
    std::vector<std::pair<BoundingBox<2>, unsigned int>> boxes;
    for (const Simplex<2> &triangle : ground.triangles)
    {
      const Point<3> &a = ground.nodes[triangle[0]].place, &b = ground.nodes[triangle[1]].place,
                     &c = ground.nodes[triangle[2]].place;
      area += 0.5 * cross_product_3d(b - a, c - a).norm();
      in_plan += plan_area(a, b, c);
      std::vector<Point<2>> corners;
      for (const unsigned int v : triangle)
        corners.push_back(ground.plan[v]);
      boxes.emplace_back(BoundingBox<2>(corners), boxes.size());
    }
    slope         = std::sqrt(area / in_plan);
    triangle_tree = pack_rtree(boxes);
  }



  double LayerBody::roughness() const
  {
    double sum = 0.;
    for (const Simplex<2> &triangle : ground.triangles)
      for (unsigned int v = 0; v < 3; ++v)
        sum += ground.nodes[triangle[v]].place.distance(ground.nodes[triangle[(v + 1) % 3]].place);
    return chord * sum / (3. * ground.triangles.size());
  }



  double LayerBody::depth() const
  {
    double largest = 0.;
    for (const GroundPoint &node : ground.nodes)
      largest = std::max(largest, node.depth);
    return largest;
  }



  GroundPoint LayerBody::at(const Point<2> &point) const
  {
    // Of the triangles around, that in which the point lies deepest.
    GroundPoint result;
    double deepest    = -std::numeric_limits<double>::max();
    const auto search = [&](const auto &predicate) {
      for (const auto &entry : triangle_tree | boost::geometry::index::adaptors::queried(predicate))
      {
        const Simplex<2> &triangle = ground.triangles[entry.second];
        const auto corners         = corners_of<2>(triangle, ground.plan);
        const Tensor<1, 2> last    = transpose(invert(edge_matrix<2>(corners))) * (point - corners[0]);
        const std::array<double, 3> shares = {{1. - last[0] - last[1], last[0], last[1]}};
        const double depth                 = *std::min_element(shares.begin(), shares.end());
        if (depth <= deepest)
          continue;
        deepest = depth;
        result  = {Point<3>(point[0], point[1], 0.), 0.};
        for (unsigned int v = 0; v < 3; ++v)
        {
          result.place[2] += shares[v] * ground.nodes[triangle[v]].place[2];
          result.depth += shares[v] * ground.nodes[triangle[v]].depth;
        }
      }
    };
    search(boost::geometry::index::intersects(point));
    if (deepest < -1e-6) // beside the rim by rounding
      search(boost::geometry::index::nearest(point, 3));
    return result;
  }



  DividedPoints<3> LayerBody::fill(const MeshSize<3> &h, const MPI_Comm &communicator) const
  {
    const auto plan_h = [&](const Point<2> &p) { return h(at(p).place) / slope; };
    std::vector<double> levels;
    for (const double level : h.levels())
      levels.push_back(level / slope);
    const std::vector<Point<2>> rim = plan.contour_points(plan_h);
    const std::vector<Point<2>> all = all_points(
      fill_contour(
        rim, [&](const Point<2> &p) { return -plan.signed_distance(p); }, plan_h, levels, communicator),
      communicator);

    std::vector<Point<3>> ground_points, sides, surface;
    for (unsigned int i = 0; i < all.size(); ++i)
    {
      const auto [place, depth] = at(all[i]);
      ground_points.push_back(place);
      if (depth < 0.5 * h(place))
        continue;
      const unsigned int n = i < rim.size() ? std::round(depth / h(place)) : 1; // steep sides at the rim
      for (unsigned int k = 1; k < n; ++k)
        sides.push_back(place + Point<3>(0., 0., k * depth / n));
      surface.push_back(place + Point<3>(0., 0., depth));
    }
    ground_points.insert(ground_points.end(), surface.begin(), surface.end());
    ground_points.insert(ground_points.end(), sides.begin(), sides.end());
    return fill_inside(*this, ground_points, h, communicator);
  }
} // namespace Lahar
