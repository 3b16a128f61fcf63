#include <lahar/remeshing/local_delaunay.h>
#include <lahar/remeshing/point_tree.h>
#include <lahar/remeshing/simplex_geometry.h>

#include <memory>

namespace Lahar
{
  namespace
  {
    /// Circumballs are searched with a radius larger by this part.
    constexpr double margin = 1e-6;

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
  } // namespace



  template <int dim>
  std::vector<Simplex<dim>> local_delaunay(const std::vector<Point<dim>> &points,
                                           const std::vector<bool> &own, const double reach,
                                           const std::function<bool(const Simplex<dim> &)> &matters)
  {
    const std::vector<BoundingBox<dim>> box = find_box(points, own, reach);
    if (box.empty())
      return {};

    std::vector<unsigned int> added, others;
    std::vector<bool> known(points.size(), false);
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      known[i] = contains_ball(box[0], points[i], 0.);
      (known[i] ? added : others).push_back(i);
    }

    DelaunayTriangulation<dim> triangulation(points);
    std::unique_ptr<PointTree<dim>> tree; // of the other points, once it is needed
    std::vector<Simplex<dim>> result;
    while (!added.empty())
    {
      triangulation.insert(added);
      added.clear();
      result.clear();
      for (const Simplex<dim> &simplex : triangulation.simplices())
      {
        const Simplex<dim> candidate = canonical<dim>(simplex);
        if (!matters(candidate))
          continue;
        result.push_back(candidate);
        const auto corners                 = corners_of<dim>(candidate, points);
        const Tensor<1, dim> centre_from_0 = to_circumcentre<dim>(corners);
        const Point<dim> centre            = corners[0] + centre_from_0;
        const double radius                = (1. + margin) * centre_from_0.norm();
        if (others.empty() || contains_ball(box[0], centre, radius))
          continue;
        if (!tree)
          tree = std::make_unique<PointTree<dim>>(points, others);
        // The centre of a flat simplex's ball is not exact: points near the surface are many, and only those that
        // lie in the ball contradict.
        const unsigned int nearest =
          tree->nearest_in_ball(centroid<dim>(corners), centre, radius, [&](const unsigned int i) {
            return !known[i] && in_circumball<dim>(corners, points[i]);
          });
        if (nearest != numbers::invalid_unsigned_int)
        {
          known[nearest] = true;
          added.push_back(nearest);
        }
      }
    }
    return result;
  }



  template std::vector<Simplex<2>> local_delaunay<2>(const std::vector<Point<2>> &, const std::vector<bool> &,
                                                     const double,
                                                     const std::function<bool(const Simplex<2> &)> &);
  template std::vector<Simplex<3>> local_delaunay<3>(const std::vector<Point<3>> &, const std::vector<bool> &,
                                                     const double,
                                                     const std::function<bool(const Simplex<3> &)> &);
} // namespace Lahar
