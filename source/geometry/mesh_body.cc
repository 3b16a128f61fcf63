// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/facet_geometry.h>
#include <lahar/geometry/mesh_body.h>
#include <lahar/geometry/point_set.h>
#include <lahar/remeshing/simplex_geometry.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Lahar
{
  template <int dim>
  MeshBody<dim>::MeshBody(const std::string &name, const std::vector<Point<dim>> &nodes,
                          const std::vector<Simplex<dim>> &simplices)
    : FluidBody<dim>(name)
    , nodes(nodes)
    , cells(simplices)
  {
    std::map<std::array<unsigned int, dim>, std::pair<std::array<Point<dim>, dim>, unsigned int>> faces;
    std::vector<CellBox> boxes;
    for (Simplex<dim> &cell : cells)
    {
      if (signed_volume<dim>(corners_of<dim>(cell, nodes)) < 0.)
        std::swap(cell[0], cell[1]);
      std::vector<Point<dim>> corners;
      for (unsigned int a = 0; a <= dim; ++a)
      {
        corners.push_back(nodes[cell[a]]);
        std::array<unsigned int, dim> face;
        std::array<Point<dim>, dim> places;
        for (unsigned int b = 0, n = 0; b <= dim; ++b)
          if (b != a)
          {
            mean_edge += nodes[cell[a]].distance(nodes[cell[b]]) / (dim * (dim + 1) * simplices.size());
            face[n]     = cell[b];
            places[n++] = nodes[cell[b]];
          }
        std::sort(face.begin(), face.end());
        const auto entry = faces.emplace(face, std::make_pair(places, 0U)).first;
        ++entry->second.second;
      }
      boxes.emplace_back(BoundingBox<dim>(corners), boxes.size());
    }
    tree = pack_rtree(boxes);
    std::vector<WallFacet<dim>> single;
    for (const auto &[face, places_and_count] : faces)
      if (places_and_count.second == 1)
      {
        const auto &corners = places_and_count.first;
        single.push_back({corners, false});
        for (unsigned int v = 0; v < dim; ++v)
          longest_edge = std::max(longest_edge, corners[v].distance(corners[(v + 1) % dim]));
      }
    facets = Walls<dim>(single);
  }



  template <int dim>
  Box<dim> MeshBody<dim>::box() const
  {
    return box_around(nodes);
  }



  template <int dim>
  double MeshBody<dim>::volume() const
  {
    double sum = 0.;
    for (const Simplex<dim> &cell : cells)
      sum += signed_volume<dim>(corners_of<dim>(cell, nodes));
    return sum;
  }



  template <int dim>
  bool MeshBody<dim>::is_inside(const Point<dim> &point) const
  {
    const double tolerance = 1e-9;
    for (const auto &[box, c] :
         tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(point)))
    {
      const auto corners          = corners_of<dim>(cells[c], nodes);
      const Tensor<1, dim> shares = transpose(invert(edge_matrix<dim>(corners))) * (point - corners[0]);
      double first                = 1.;
      bool inside                 = true;
      for (unsigned int d = 0; d < dim; ++d)
      {
        first -= shares[d];
        inside = inside && shares[d] > -tolerance;
      }
      if (inside && first > -tolerance)
        return true;
    }
    return false;
  }



  template <int dim>
  double MeshBody<dim>::signed_distance(const Point<dim> &point) const
  {
    double distance = longest_edge;
    for (const unsigned int f : facets.near(point, longest_edge))
      distance = std::min(distance, nearest_point<dim>(facets.facets()[f].corners, point).distance(point));
    return is_inside(point) ? -distance : distance;
  }



  template <int dim>
  double MeshBody<dim>::roughness() const
  {
    return 0.05 * mean_edge;
  }



  template <int dim>
  double MeshBody<dim>::estimate_size(const double h) const
  {
    return nodes.size() + volume() / std::pow(h, dim) * (dim == 2 ? 1.2 : 1.6);
  }



  template <int dim>
  unsigned int MeshBody<dim>::n_normals_at(const Point<dim> &point) const
  {
    // Orthogonal parts of the normals that are longer than the sine of 20 degrees.
    std::vector<Tensor<1, dim>> directions;
    const double tolerance = 1e-9 * longest_edge;
    for (const unsigned int f : facets.near(point, tolerance))
      if (nearest_point<dim>(facets.facets()[f].corners, point).distance(point) < tolerance)
      {
        Tensor<1, dim> rest = facets.normal(f);
        for (const Tensor<1, dim> &direction : directions)
          rest -= (rest * direction) * direction;
        if (rest.norm() > std::sin(20. / 180. * numbers::PI))
          directions.push_back(rest / rest.norm());
      }
    return directions.size();
  }



  namespace
  {
    /// Append the middles of edges by which the simplex must be bisected until none is longer than 1.5 h.
    template <int dim>
    void bisect(const SimplexCorners<dim> &corners, const MeshSize<dim> &h, std::vector<Point<dim>> &middles)
    {
      unsigned int first = 0, second = 0;
      double longest = 1.5;
      Point<dim> middle;
      for (unsigned int a = 0; a <= dim; ++a)
        for (unsigned int b = 0; b < a; ++b)
        {
          const Point<dim> candidate = corners[a] + 0.5 * (corners[b] - corners[a]);
          const double length        = corners[a].distance(corners[b]) / h(candidate);
          if (length > longest)
          {
            longest = length;
            first   = a;
            second  = b;
            middle  = candidate;
          }
        }
      if (first == second)
        return;
      middles.push_back(middle);
      for (const unsigned int replaced : {first, second})
      {
        SimplexCorners<dim> half = corners;
        half[replaced]           = middle;
        bisect<dim>(half, h, middles);
      }
    }
  } // namespace



  template <int dim>
  std::vector<Point<dim>> MeshBody<dim>::fill(const MeshSize<dim> &h) const
  {
    std::vector<Point<dim>> points = nodes;
    for (const Simplex<dim> &cell : cells)
      bisect<dim>(corners_of<dim>(cell, nodes), h, points);

    std::vector<std::vector<Point<dim>>> by_rank(dim + 1);
    for (const Point<dim> &p : points)
      by_rank[n_normals_at(p)].push_back(p);
    std::vector<Point<dim>> result;
    PointSet<dim> places;
    for (unsigned int rank = dim + 1; rank-- > 0;)
      for (const Point<dim> &p : by_rank[rank])
        if ((rank > 0 || signed_distance(p) < -0.5 * h(p)) &&
            places.insert_if_free(p, (rank == dim ? 0.1 : 0.6) * h(p)))
          result.push_back(p);
    return result;
  }



  template <int dim>
  std::vector<std::array<Point<dim>, dim>> MeshBody<dim>::contour() const
  {
    std::vector<std::array<Point<dim>, dim>> result;
    for (const WallFacet<dim> &facet : facets.facets())
      result.push_back(facet.corners);
    return result;
  }



  template class MeshBody<2>;
  template class MeshBody<3>;
} // namespace Lahar
