// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/far_points.h>
#include <lahar/remeshing/local_delaunay.h>
#include <lahar/remeshing/point_tree.h>

#include <memory>

namespace Lahar
{
  namespace
  {
    /// Circumballs are searched with a radius larger by this part.
    constexpr double margin = 1e-6;

    /// The most points that are used of a simplex's circumball at a time.
    constexpr unsigned int most_wanted = 64;

    /// The bounding box of the own points, widened by the reach; none if there is no own point.
    template <int dim>
    std::vector<BoundingBox<dim>> find_box(const std::vector<Point<dim>> &points,
                                           const std::vector<bool> &own, const double reach)
    {
      std::vector<Point<dim>> own_points;
      for (unsigned int i = 0; i < points.size(); ++i)
        if (own[i])
          own_points.push_back(points[i]);
      if (own_points.empty())
        return {};
      BoundingBox<dim> box(own_points);
      box.extend((1. + margin) * reach);
      return {box};
    }

    template <int dim>
    bool contains_ball(const BoundingBox<dim> &box, const Point<dim> &centre, const double radius)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (!(centre[d] - radius >= box.lower_bound(d) && centre[d] + radius <= box.upper_bound(d)))
          return false;
      return true;
    }

    /**
     * local_delaunay() with a @p triangulation of @p points, which are the cloud's and to which far ones are added.
     * @param used_anyway by particle: to be used at first besides those in the box.
     * @param growth by which more points are used each time that a simplex has stood.
     */
    template <int dim, typename Triangulation>
    std::vector<Simplex<dim>> find_simplices(const WantedSimplices<dim> &wanted,
                                             std::vector<Point<dim>> &points,
                                             const std::vector<bool> &used_anyway, const unsigned int growth,
                                             Triangulation &triangulation)
    {
      const ParticleCloud<dim> &cloud         = wanted.cloud;
      const std::vector<bool> &own            = wanted.own;
      const double reach                      = wanted.reach;
      const Migration<dim> &migration         = wanted.migration;
      const std::vector<BoundingBox<dim>> box = find_box(points, own, reach);
      std::vector<unsigned int> added, others;
      std::vector<bool> used = used_anyway;
      for (unsigned int i = 0; i < cloud.size(); ++i)
      {
        if (cloud.kind[i] == ParticleKind::slick_solid)
          continue;
        used[i] = !box.empty() && (used[i] || contains_ball(box[0], points[i], 0.));
        (used[i] ? added : others).push_back(i);
      }

      std::unique_ptr<PointTree<dim>> tree; // of the other points, once it is needed
      FarPoints<dim> far_points(cloud, migration, reach);
      std::vector<Simplex<dim>> result;
      unsigned int n_wanted = 1;
      for (bool any = true; any; n_wanted = std::min(growth * n_wanted, most_wanted))
      {
        if (!added.empty())
          triangulation.insert(added);
        added.clear();
        result.clear();
        std::vector<typename FarPoints<dim>::Query> queries;
        if (!box.empty())
          for (const Simplex<dim> &simplex : triangulation.simplices())
          {
            const Simplex<dim> candidate = canonical<dim>(simplex);
            if (*std::max_element(candidate.begin(), candidate.end()) >= cloud.size() ||
                !wanted.matters(candidate))
              continue;
            result.push_back(candidate);
            const auto corners                 = corners_of<dim>(candidate, points);
            const Tensor<1, dim> centre_from_0 = to_circumcentre<dim>(corners);
            const Point<dim> centre            = corners[0] + centre_from_0;
            const double radius                = (1. + margin) * centre_from_0.norm();
            if (contains_ball(box[0], centre, radius))
              continue;
            if (far_points.is_open(centre, radius))
              queries.push_back({corners, n_wanted});
            if (others.empty())
              continue;
            if (!tree)
              tree = std::make_unique<PointTree<dim>>(cloud.position, others);
            // The centre of a flat simplex's ball is not exact: points near the surface are many, and only those that
            // lie in the ball contradict.
            for (unsigned int n = 0; n < n_wanted; ++n)
            {
              const unsigned int nearest =
                tree->nearest_in_ball(centroid<dim>(corners), centre, radius, [&](const unsigned int i) {
                  return !used[i] && in_circumball<dim>(corners, points[i]);
                });
              if (nearest == numbers::invalid_unsigned_int)
                break;
              used[nearest] = true;
              added.push_back(nearest);
            }
          }
        if (!migration.is_alone())
          for (const Point<dim> &point : far_points.find(queries))
          {
            added.push_back(points.size());
            points.push_back(point);
          }
        any = !added.empty();
        if (!migration.is_alone())
          any = Utilities::MPI::max(any ? 1U : 0U, migration.communicator()) == 1U;
      }
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<Simplex<dim>>
  local_delaunay(const ParticleCloud<dim> &cloud, const std::vector<bool> &own, const double reach,
                 const std::function<bool(const Simplex<dim> &)> &matters, const Migration<dim> &migration)
  {
    std::vector<Point<dim>> points = cloud.position;
    DelaunayTriangulation<dim> triangulation(points);
    return find_simplices<dim>({cloud, own, reach, matters, migration}, points,
                               std::vector<bool>(cloud.size(), false), 1, triangulation);
  }



  std::vector<Simplex<2>> local_constrained_delaunay(const WantedSimplices<2> &wanted,
                                                     const std::vector<std::array<unsigned int, 2>> &segments,
                                                     const unsigned int n_required, std::vector<bool> &forced)
  {
    std::vector<Point<2>> points = wanted.cloud.position;
    std::vector<bool> used(wanted.cloud.size(), false);
    for (const auto &segment : segments)
      for (const unsigned int i : segment)
        used[i] = true;
    ConstrainedDelaunay triangulation(points, segments, n_required);
    const auto result = find_simplices<2>(wanted, points, used, 2, triangulation);
    forced            = triangulation.forced();
    return result;
  }



  template std::vector<Simplex<2>> local_delaunay<2>(const ParticleCloud<2> &, const std::vector<bool> &,
                                                     const double,
                                                     const std::function<bool(const Simplex<2> &)> &,
                                                     const Migration<2> &);
  template std::vector<Simplex<3>> local_delaunay<3>(const ParticleCloud<3> &, const std::vector<bool> &,
                                                     const double,
                                                     const std::function<bool(const Simplex<3> &)> &,
                                                     const Migration<3> &);
} // namespace Lahar
