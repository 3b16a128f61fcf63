// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>
#include <lahar/geometry/lattice.h>
#include <lahar/geometry/mesh_body.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/polygon.h>
#include <lahar/geometry/symmetry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Lahar
{
  namespace
  {
    template <int dim>
    double distance_to(const BoundingBox<dim> &box, const Point<dim> &point)
    {
      const auto &[lower, upper] = box.get_boundary_points();
      double square              = 0.;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double beside = std::max({0., lower[d] - point[d], point[d] - upper[d]});
        square += beside * beside;
      }
      return std::sqrt(square);
    }
  } // namespace



  template <int dim>
  MeshBody<dim>::MeshBody(const std::string &name, const std::vector<Point<dim>> &nodes,
                          const std::vector<Simplex<dim>> &simplices)
    : FluidBody<dim>(name)
    , nodes(nodes)
    , cells(simplices)
  {
    using Face = std::array<unsigned int, dim>;
    std::map<Face, std::pair<Face, unsigned int>>
      faces; // by sorted nodes: in order, and the number of simplices
    std::vector<NumberedBox> boxes;
    for (Simplex<dim> &cell : cells)
    {
      if (signed_volume<dim>(corners_of<dim>(cell, nodes)) < 0.)
        std::swap(cell[0], cell[1]);
      std::vector<Point<dim>> corners;
      for (unsigned int a = 0; a <= dim; ++a)
      {
        corners.push_back(nodes[cell[a]]);
        Face face;
        for (unsigned int k = 0; k < dim; ++k)
        {
          face[k] = cell[(a + 1 + k) % (dim + 1)];
          mean_edge += nodes[cell[a]].distance(nodes[face[k]]) / (dim * (dim + 1) * simplices.size());
        }
        Face sorted = face;
        std::sort(sorted.begin(), sorted.end());
        ++faces.emplace(sorted, std::make_pair(face, 0U)).first->second.second;
      }
      boxes.emplace_back(BoundingBox<dim>(corners), boxes.size());
    }
    tree = pack_rtree(boxes);

    std::vector<WallFacet<dim>> single;
    for (const auto &[sorted, face_and_count] : faces)
      if (face_and_count.second == 1)
      {
        WallFacet<dim> facet;
        Point<dim> middle;
        for (unsigned int v = 0; v < dim; ++v)
        {
          facet.corners[v] = nodes[face_and_count.first[v]];
          middle += facet.corners[v] / double(dim);
        }
        // Between parts that do not share their nodes.
        const Tensor<1, dim> step = 1e-6 * facet.corners[0].distance(facet.corners[1]) *
                                    Walls<dim>({facet}).normal(0);
        if (is_inside(middle + step) && is_inside(middle - step))
          continue;
        facet_nodes.push_back(face_and_count.first);
        single.push_back(facet);
        for (unsigned int v = 0; v < dim; ++v)
          longest_edge = std::max(longest_edge, facet.corners[v].distance(facet.corners[(v + 1) % dim]));
      }
    facets = Walls<dim>(single);
    boxes.clear();
    for (const WallFacet<dim> &facet : single)
      boxes.emplace_back(BoundingBox<dim>(facet.corners), boxes.size());
    facet_tree = pack_rtree(boxes);
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
      sum += body_volume<dim>(corners_of<dim>(cell, nodes));
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
    // By the distance of the boxes around the facets, which is at most that of the facets. A query for all boxes at once
    // would sort many that are not needed.
    double distance = std::numeric_limits<double>::max(), of_boxes = 0.;
    for (std::size_t n = 8; of_boxes < distance; n *= 8)
    {
      for (const NumberedBox &box :
           facet_tree | boost::geometry::index::adaptors::queried(boost::geometry::index::nearest(point, n)))
      {
        const double of_box = distance_to(box.first, point);
        of_boxes            = std::max(of_boxes, of_box);
        if (of_box < distance)
          distance = std::min(distance,
                              nearest_point<dim>(facets.facets()[box.second].corners, point).distance(point));
      }
      if (n >= facet_tree.size())
        break;
    }
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
    double size = 0.;
    for (const Simplex<dim> &cell : cells)
      size += signed_volume<dim>(corners_of<dim>(cell, nodes));
    double n = nodes.size() + size / std::pow(h, dim) * (dim == 2 ? 1.2 : 1.6);
    // Spikes have much of a contour and little volume.
    for (const WallFacet<dim> &facet : facets.facets())
    {
      double longest = 0.;
      for (unsigned int v = 0; v < dim; ++v)
        longest = std::max(longest, facet.corners[v].distance(facet.corners[(v + 1) % dim]) / h);
      if (longest <= 1.4)
        continue;
      n += longest;
      if constexpr (dim == 3)
        n +=
          0.6 / (h * h) *
          cross_product_3d(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]).norm();
    }
    return n;
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
    /// Append the middles of edges by which a facet must be bisected until none is longer than 1.4 h.
    void bisect(const std::array<Point<3>, 3> &corners, const SizeFunction<3> &h,
                std::vector<Point<3>> &middles)
    {
      unsigned int opposite = 3;
      double longest        = 1.4;
      Point<3> middle;
      for (unsigned int v = 0; v < 3; ++v)
      {
        const Point<3> &a = corners[(v + 1) % 3], &b = corners[(v + 2) % 3];
        const Point<3> candidate = a + 0.5 * (b - a);
        const double length      = a.distance(b) / h(candidate);
        if (length > longest)
        {
          longest  = length;
          opposite = v;
          middle   = candidate;
        }
      }
      if (opposite == 3)
        return;
      middles.push_back(middle);
      bisect({{corners[opposite], corners[(opposite + 1) % 3], middle}}, h, middles);
      bisect({{corners[opposite], middle, corners[(opposite + 2) % 3]}}, h, middles);
    }

    /// Append the beginnings of pieces of a polyline that have nearly equal integrals ∫ ds/h.
    void append_pieces(const std::vector<Point<2>> &line, const SizeFunction<2> &h,
                       std::vector<Point<2>> &points)
    {
      std::vector<Point<2>> places(1, line[0]);
      std::vector<double> integral(1, 0.);
      for (unsigned int i = 1; i < line.size(); ++i)
      {
        const double length  = line[i].distance(line[i - 1]);
        const unsigned int n = std::ceil(length / (0.05 * std::min(h(line[i]), h(line[i - 1]))));
        for (unsigned int k = 1; k <= n; ++k)
        {
          const Point<2> middle = line[i - 1] + (k - 0.5) / n * (line[i] - line[i - 1]);
          places.push_back(line[i - 1] + double(k) / n * (line[i] - line[i - 1]));
          integral.push_back(integral.back() + length / n / h(middle));
        }
      }
      const unsigned int n = std::max(1., std::round(integral.back()));
      for (unsigned int k = 0, i = 0; k < n; ++k)
      {
        const double wanted = double(k) / n * integral.back();
        while (integral[i + 1] <= wanted)
          ++i;
        points.push_back(places[i] + (wanted - integral[i]) / (integral[i + 1] - integral[i]) *
                                       (places[i + 1] - places[i]));
      }
    }
  } // namespace



  template <>
  std::vector<Point<2>> MeshBody<2>::divided_contour(const SizeFunction<2> &h) const
  {
    std::multimap<unsigned int, unsigned int> next;
    for (const auto &[a, b] : facet_nodes)
      next.emplace(a, b);
    std::vector<Point<2>> points;
    while (!next.empty())
    {
      std::vector<Point<2>> chain;
      for (auto edge = next.begin(); edge != next.end();)
      {
        const Point<2> &to = nodes[edge->second];
        chain.push_back(nodes[edge->first]);
        next.erase(edge);
        edge = std::find_if(next.begin(), next.end(), [&](const auto &candidate) {
          return nodes[candidate.first].distance(to) < 1e-9 * longest_edge;
        });
      }
      // From corner to corner.
      const auto is_corner = [this](const Point<2> &p) { return n_normals_at(p) == 2; };
      std::rotate(chain.begin(), std::find_if(chain.begin(), chain.end(), is_corner), chain.end());
      chain.push_back(chain[0]);
      std::vector<Point<2>> line(1, chain[0]);
      for (unsigned int i = 1; i < chain.size(); ++i)
      {
        line.push_back(chain[i]);
        if (i + 1 == chain.size() || is_corner(chain[i]))
        {
          append_pieces(line, h, points);
          line.assign(1, chain[i]);
        }
      }
    }
    return points;
  }



  template <>
  std::vector<Point<3>> MeshBody<3>::divided_contour(const SizeFunction<3> &h) const
  {
    std::vector<Point<3>> points;
    for (const WallFacet<3> &facet : facets.facets())
    {
      points.insert(points.end(), facet.corners.begin(), facet.corners.end());
      bisect(facet.corners, h, points);
    }
    return points;
  }



  namespace
  {
    DividedPoints<2> fill_inside(const MeshBody<2> &body, const std::vector<Point<2>> &contour,
                                 const MeshSize<2> &h, const MPI_Comm &communicator)
    {
      return fill_contour(
        contour, [&](const Point<2> &p) { return -body.signed_distance(p); }, h, h.levels(), communicator);
    }
  } // namespace



  template <int dim>
  std::vector<Point<dim>> MeshBody<dim>::contour_points(const SizeFunction<dim> &h) const
  {
    std::vector<std::vector<Point<dim>>> by_rank(dim + 1);
    for (const Point<dim> &p : divided_contour(h))
      by_rank[n_normals_at(p)].push_back(p);
    std::vector<Point<dim>> result;
    PointSet<dim> places;
    for (unsigned int rank = dim + 1; rank-- > 1;)
      for (const Point<dim> &p : by_rank[rank])
        if (places.insert_if_free(p, (rank == dim ? 0.1 : dim == 2 ? 0.5 : 0.7) * h(p)))
          result.push_back(p);
    return result;
  }



  template <int dim>
  DividedPoints<dim> MeshBody<dim>::fill(const MeshSize<dim> &h, const MPI_Comm &communicator) const
  {
    return fill_inside(*this, contour_points(h), h, communicator);
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
