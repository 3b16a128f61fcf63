// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/facet_geometry.h>
#include <lahar/geometry/mesh_body.h>
#include <lahar/remeshing/simplex_geometry.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace Lahar
{
  template <int dim>
  MeshBody<dim>::MeshBody(const std::string &name, const std::vector<Point<dim>> &nodes,
                          const std::vector<Simplex<dim>> &simplices)
    : FluidBody<dim>(name)
    , nodes(nodes)
    , cells(simplices)
  {
    std::vector<double> sum(nodes.size(), 0.), count = sum;
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
            sum[cell[a]] += nodes[cell[a]].distance(nodes[cell[b]]);
            count[cell[a]] += 1.;
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
    for (unsigned int i = 0; i < nodes.size(); ++i)
      edge_length.push_back(sum[i] / count[i]);

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
    return 0.1 * std::accumulate(edge_length.begin(), edge_length.end(), 0.) / edge_length.size();
  }



  template <int dim>
  double MeshBody<dim>::estimate_size(const double) const
  {
    return nodes.size();
  }



  template <int dim>
  std::vector<Point<dim>> MeshBody<dim>::fill(const MeshSize<dim> &) const
  {
    return nodes;
  }



  template <int dim>
  std::vector<double> MeshBody<dim>::distances(const std::vector<Point<dim>> &, const MeshSize<dim> &) const
  {
    return edge_length;
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
