// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/solid_contour.h>
#include <lahar/geometry/facet_geometry.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace Lahar
{
  namespace
  {
    /// Distance from the contour at which particles are put, over their spacing.
    constexpr double clearance = 0.1;

    /// A path that misses a facet by less than this times the spacing meets it: paths between facets must not slip
    /// through.
    constexpr double meeting_tolerance = 1e-3;

    template <int dim>
    std::vector<WallFacet<dim>> shapes_of(const std::vector<std::array<unsigned int, dim>> &facets,
                                          const ParticleCloud<dim> &cloud,
                                          const std::vector<Point<dim>> &position)
    {
      std::vector<WallFacet<dim>> shapes;
      for (const auto &facet : facets)
      {
        WallFacet<dim> shape;
        for (unsigned int v = 0; v < dim; ++v)
          shape.corners[v] = position[facet[v]];
        shape.lands    = cloud.kind[facet[0]] == ParticleKind::slick_solid;
        shape.boundary = cloud.part[facet[0]];
        shapes.push_back(shape);
      }
      return shapes;
    }

    /// The angle (solid angle in 3D) of a facet seen from @p point, over the full one.
    double angle_share(const std::array<Point<2>, 2> &corners, const Point<2> &point)
    {
      const Tensor<1, 2> a = corners[0] - point, b = corners[1] - point;
      return std::atan2(a[0] * b[1] - a[1] * b[0], a * b) / (2. * numbers::PI);
    }

    /// Van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125–126.
    double angle_share(const std::array<Point<3>, 3> &corners, const Point<3> &point)
    {
      const Tensor<1, 3> a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
      const double a_b_c       = a * cross_product_3d(b, c);
      const double denominator = a.norm() * b.norm() * c.norm() + (a * b) * c.norm() + (a * c) * b.norm() +
                                 (b * c) * a.norm();
      return std::atan2(a_b_c, denominator) / (2. * numbers::PI);
    }

    template <typename Values, std::size_t n>
    auto mean(const Values &values, const std::array<unsigned int, n> &facet,
              const std::array<double, n> &shares)
    {
      auto sum = shares[0] * values[facet[0]];
      for (unsigned int v = 1; v < n; ++v)
        sum += shares[v] * values[facet[v]];
      return sum;
    }
  } // namespace



  template <int dim>
  SolidContour<dim>::SolidContour(const std::vector<Facet> &facets, const ParticleCloud<dim> &cloud,
                                  const double unevenness)
    : particles(facets)
    , shapes(shapes_of<dim>(facets, cloud, cloud.position))
    , uneven(unevenness)
  {
    std::vector<Point<dim>> points;
    for (const Facet &facet : particles)
      for (const unsigned int particle : facet)
        points.push_back(cloud.position[particle]);
    if (!points.empty())
      box = BoundingBox<dim>(points);
  }



  template <int dim>
  std::vector<typename SolidContour<dim>::Facet> SolidContour<dim>::facets_that_land(const bool lands) const
  {
    std::vector<Facet> result;
    for (unsigned int f = 0; f < particles.size(); ++f)
      if (shapes.facets()[f].lands == lands)
        result.push_back(particles[f]);
    return result;
  }



  template <int dim>
  std::vector<WallFacet<dim>> SolidContour<dim>::wall_facets_that_land(const bool lands) const
  {
    std::vector<WallFacet<dim>> result;
    std::copy_if(shapes.facets().begin(), shapes.facets().end(), std::back_inserter(result),
                 [lands](const WallFacet<dim> &facet) { return facet.lands == lands; });
    return result;
  }



  template <int dim>
  bool SolidContour<dim>::is_inside(const Point<dim> &point) const
  {
    if (particles.empty() || !box.point_inside(point))
      return false;
    double winding_number = 0.;
    for (const WallFacet<dim> &facet : shapes.facets())
      winding_number += angle_share(facet.corners, point);
    return winding_number > 0.5;
  }



  template <int dim>
  unsigned int SolidContour<dim>::nearest_facet(const Point<dim> &point) const
  {
    unsigned int nearest   = 0;
    double smallest_square = std::numeric_limits<double>::max();
    for (unsigned int f = 0; f < particles.size(); ++f)
    {
      const auto &corners = shapes.facets()[f].corners;
      const double square = nearest_point<dim>(corners, point).distance_square(point);
      if (square < smallest_square)
      {
        smallest_square = square;
        nearest         = f;
      }
    }
    return nearest;
  }



  template <int dim>
  void SolidContour<dim>::put_before(const unsigned int f, const unsigned int particle,
                                     ParticleCloud<dim> &cloud) const
  {
    const auto &corners      = shapes.facets()[f].corners;
    const auto shares        = nearest_shares(corners, cloud.position[particle]);
    cloud.position[particle] = point_of<dim>(corners, shares) +
                               clearance * cloud.spacing[particle] * shapes.normal(f);
    cloud.velocity[particle]                 = mean(cloud.velocity, particles[f], shares);
    cloud.acceleration[particle]             = Tensor<1, dim>();
    cloud.algorithmic_acceleration[particle] = Tensor<1, dim>();
  }



  template <int dim>
  unsigned int SolidContour<dim>::keep_out(const std::vector<Point<dim>> &old_position,
                                           ParticleCloud<dim> &cloud) const
  {
    unsigned int n_put = 0;
    if (particles.empty())
      return n_put;
    const Walls<dim> old_shapes(shapes_of<dim>(particles, cloud, old_position));
    for (unsigned int i = 0; i < cloud.size(); ++i)
    {
      if (cloud.kind[i] != ParticleKind::fluid)
        continue;
      const double reach = (cloud.position[i] - old_position[i]).norm() + cloud.spacing[i];
      bool near          = true;
      for (unsigned int d = 0; d < dim; ++d)
        near = near && cloud.position[i][d] > box.get_boundary_points().first[d] - reach &&
               cloud.position[i][d] < box.get_boundary_points().second[d] + reach;
      if (!near)
        continue;

      bool put = false;
      for (const unsigned int f : shapes.near(cloud.position[i], reach))
      {
        const double before = old_shapes.signed_distance(f, old_position[i]);
        const double after  = shapes.signed_distance(f, cloud.position[i]);
        if (before < 0. || after >= 0.)
          continue;
        // Where the particle meets the plane of the facet, and whether that is on the facet.
        const double time  = before / (before - after);
        const auto on_path = [&](const unsigned int particle) {
          return old_position[particle] + time * (cloud.position[particle] - old_position[particle]);
        };
        const Point<dim> meeting = on_path(i);
        std::array<Point<dim>, dim> corners;
        for (unsigned int v = 0; v < dim; ++v)
          corners[v] = on_path(particles[f][v]);
        const Point<dim> nearest = nearest_point<dim>(corners, meeting);
        if (meeting.distance(nearest) < meeting_tolerance * cloud.spacing[i])
        {
          put_before(f, i, cloud);
          put = true;
          break;
        }
      }
      if (!put && is_inside(cloud.position[i]))
      {
        put_before(nearest_facet(cloud.position[i]), i, cloud);
        put = true;
      }
      n_put += (put && cloud.is_own(i));
    }
    return n_put;
  }



  template class SolidContour<2>;
  template class SolidContour<3>;
} // namespace Lahar
