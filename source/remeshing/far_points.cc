// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/vector.hpp>

#include <lahar/remeshing/far_points.h>

namespace Lahar
{
  namespace
  {
    /// Circumballs are searched with a radius larger by this part.
    constexpr double ball_margin = 1e-6;
  } // namespace



  template <int dim>
  FarPoints<dim>::FarPoints(const ParticleCloud<dim> &cloud, const Migration<dim> &migration,
                            const double margin)
    : cloud(cloud)
    , migration(migration)
    , margin(margin)
  {
    if (migration.is_alone())
      return;
    for (const BoundingBox<dim> &box : migration.boxes()[cloud.rank])
      for (unsigned int d = 0; d < dim; ++d)
      {
        known.push_back(box.lower_bound(d) - migration.distance() + margin);
        known.push_back(box.upper_bound(d) + migration.distance() - margin);
      }
  }



  template <int dim>
  bool FarPoints<dim>::is_in_box(const Point<dim> &point, const double *bounds)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!(point[d] >= bounds[2 * d] && point[d] <= bounds[2 * d + 1]))
        return false;
    return true;
  }



  template <int dim>
  bool FarPoints<dim>::is_open(const Point<dim> &centre, const double radius) const
  {
    if (migration.is_alone())
      return false;
    for (unsigned int d = 0; d < dim; ++d)
      if (!(centre[d] - radius >= known[2 * d] && centre[d] + radius <= known[2 * d + 1]))
        return true;
    return false;
  }



  template <int dim>
  std::vector<Point<dim>> FarPoints<dim>::find(const std::vector<Query> &queries)
  {
    std::map<unsigned int, std::vector<double>> questions;
    for (const auto &[corners, n_wanted] : queries)
    {
      const Tensor<1, dim> to_centre = to_circumcentre<dim>(corners);
      const double radius            = (1. + ball_margin) * to_centre.norm() + margin;
      for (unsigned int r = 0; r < migration.boxes().size(); ++r)
        for (const BoundingBox<dim> &box : migration.boxes()[r])
        {
          double distance_square = 0.;
          for (unsigned int d = 0; d < dim; ++d)
          {
            const double x       = corners[0][d] + to_centre[d],
                         outside = std::max({box.lower_bound(d) - x, x - box.upper_bound(d), 0.});
            distance_square += outside * outside;
          }
          if (r == cloud.rank || !(distance_square <= radius * radius))
            continue;
          std::vector<double> &question = questions[r];
          if (question.empty())
            question = known;
          for (const Point<dim> &corner : corners)
            question.insert(question.end(), corner.begin_raw(), corner.end_raw());
          question.push_back(n_wanted);
        }
    }
    std::map<unsigned int, std::vector<double>> answers;
    for (const auto &[asker, question] : Utilities::MPI::some_to_some(migration.communicator(), questions))
      if (const std::vector<double> points = answer(asker, question); !points.empty())
        answers[asker] = points;
    std::vector<Point<dim>> result;
    for (const auto &[rank, values] : Utilities::MPI::some_to_some(migration.communicator(), answers))
      for (unsigned int i = 0; i < values.size(); i += dim)
      {
        result.emplace_back();
        std::copy_n(values.begin() + i, dim, result.back().begin_raw());
      }
    return result;
  }



  template <int dim>
  std::vector<double> FarPoints<dim>::answer(const unsigned int asker, const std::vector<double> &questions)
  {
    if (!tree)
    {
      std::vector<unsigned int> own;
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (cloud.is_own(i) && cloud.kind[i] != ParticleKind::slick_solid)
          own.push_back(i);
      tree = std::make_unique<PointTree<dim>>(cloud.position, own);
    }
    std::vector<bool> &is_told = told[asker];
    is_told.resize(cloud.size(), false);
    const double *bounds = questions.data();
    std::vector<double> result;
    for (auto value = questions.begin() + 2 * dim; value != questions.end();)
    {
      SimplexCorners<dim> corners;
      for (Point<dim> &corner : corners)
      {
        std::copy_n(value, dim, corner.begin_raw());
        value += dim;
      }
      const unsigned int n_wanted    = *value++;
      const Tensor<1, dim> to_centre = to_circumcentre<dim>(corners);
      for (unsigned int n = 0; n < n_wanted; ++n)
      {
        const unsigned int nearest =
          tree->nearest_in_ball(centroid<dim>(corners), corners[0] + to_centre,
                                (1. + ball_margin) * to_centre.norm(), [&](const unsigned int i) {
                                  return !is_told[i] && !is_in_box(cloud.position[i], bounds) &&
                                         in_circumball<dim>(corners, cloud.position[i]);
                                });
        if (nearest == numbers::invalid_unsigned_int)
          break;
        is_told[nearest] = true;
        result.insert(result.end(), cloud.position[nearest].begin_raw(), cloud.position[nearest].end_raw());
      }
    }
    return result;
  }



  template class FarPoints<2>;
  template class FarPoints<3>;
} // namespace Lahar
