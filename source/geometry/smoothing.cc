// SPDX-License-Identifier: GPL-3.0-or-later

#include <deal.II/base/bounding_box.h>

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/smoothing.h>
#include <lahar/utilities/in_buckets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Lahar
{
  namespace
  {
    /// Points so far around a part, over the largest h in it, are used at first: most circumballs reach no farther.
    constexpr double first_margin = 2.;

    /// Of a simplex below this part of the cube (square) of its longest edge the circumball is not known.
    constexpr double flat = 1e-8;

    /// Balls are taken for larger by this part, beyond rounding.
    constexpr double margin = 1e-6;

    template <int dim>
    BoundingBox<dim> box_of(const std::vector<Point<dim>> &points, const std::vector<unsigned int> &indices)
    {
      std::pair<Point<dim>, Point<dim>> corners(points[indices[0]], points[indices[0]]);
      for (const unsigned int i : indices)
        for (unsigned int d = 0; d < dim; ++d)
        {
          corners.first[d]  = std::min(corners.first[d], points[i][d]);
          corners.second[d] = std::max(corners.second[d], points[i][d]);
        }
      return BoundingBox<dim>(corners);
    }

    /// Rank @p rank's part of points when the longest side of the box around them is cut in proportion to the ranks on
    /// both sides, and so on.
    template <int dim>
    std::vector<unsigned int> part_of(const std::vector<Point<dim>> &points,
                                      std::vector<unsigned int> indices, unsigned int rank,
                                      unsigned int n_ranks)
    {
      while (n_ranks > 1 && !indices.empty())
      {
        const BoundingBox<dim> box = box_of(points, indices);
        unsigned int axis          = 0;
        for (unsigned int d = 1; d < dim; ++d)
          if (box.side_length(d) > box.side_length(axis))
            axis = d;
        const unsigned int n_below = n_ranks / 2;
        const auto cut             = indices.begin() + std::size_t(indices.size()) * n_below / n_ranks;
        std::nth_element(indices.begin(), cut, indices.end(),
                         [&](const unsigned int a, const unsigned int b) {
                           return std::make_pair(points[a][axis], a) < std::make_pair(points[b][axis], b);
                         });
        const bool is_below = rank < n_below;
        indices             = is_below ? std::vector<unsigned int>(indices.begin(), cut)
                                       : std::vector<unsigned int>(cut, indices.end());
        rank -= is_below ? 0 : n_below;
        n_ranks = is_below ? n_below : n_ranks - n_below;
      }
      std::sort(indices.begin(), indices.end());
      return indices;
    }

    /// The Delaunay neighbours of some points among all of them, from a triangulation of what is around them.
    template <int dim>
    class LocalStars
    {
    public:
      /// Of the points @p wanted; @p points must outlive this object.
      LocalStars(const std::vector<Point<dim>> &points, const std::vector<unsigned int> &wanted)
        : points(points)
        , wanted(wanted)
        , number(points.size(), numbers::invalid_unsigned_int)
      {
        for (unsigned int k = 0; k < wanted.size(); ++k)
          number[wanted[k]] = k;
      }

      /// Call @p action for each of the points with its place in the list and its neighbours, ascending, each of them
      /// as often as both share simplices. @p distance (m) around the points is looked at first.
      template <typename Action>
      void for_each(const double distance, const Action &action) const
      {
        // A star is that of all points if it is closed and no other point lies in the balls of its simplices.
        DelaunayTriangulation<dim> triangulation(points);
        BoundingBox<dim> box = box_of(points, wanted);
        box.extend(distance);
        std::vector<bool> used(points.size(), false);
        std::vector<Simplex<dim>> simplices;
        for (bool is_whole = false, done = false; !done;)
        {
          is_whole  = insert(box, used, triangulation) == points.size();
          simplices = triangulation.simplices();
          done      = is_whole || !extend(simplices, box);
        }
        for_each_star(simplices, action);
      }

    private:
      /// Insert the points of a box that have not been. @return how many are.
      std::size_t insert(const BoundingBox<dim> &box, std::vector<bool> &used,
                         DelaunayTriangulation<dim> &triangulation) const
      {
        std::vector<unsigned int> added;
        std::size_t n = 0;
        for (unsigned int i = 0; i < points.size(); ++i)
        {
          if (!used[i] && box.point_inside(points[i]))
          {
            used[i] = true;
            added.push_back(i);
          }
          n += used[i];
        }
        triangulation.insert(added);
        return n;
      }

      template <typename Action>
      void for_each_star(const std::vector<Simplex<dim>> &simplices, const Action &action) const
      {
        const auto for_each_pair = [&](const auto &visit) {
          for (const Simplex<dim> &simplex : simplices)
            for (const unsigned int i : simplex)
              if (number[i] != numbers::invalid_unsigned_int)
                for (const unsigned int other : simplex)
                  if (other != i)
                    visit(number[i], other);
        };
        in_buckets(wanted.size(), for_each_pair,
                   [&](const unsigned int k, std::vector<unsigned int> &others) {
                     std::sort(others.begin(), others.end());
                     action(k, others);
                   });
      }

      /// Extend the box by what the wanted stars depend on. @return whether there is such.
      bool extend(const std::vector<Simplex<dim>> &simplices, BoundingBox<dim> &box) const
      {
        bool is_known = true, changed = false;
        for (const Simplex<dim> &simplex : simplices)
          if (std::any_of(simplex.begin(), simplex.end(),
                          [&](const unsigned int i) { return number[i] != numbers::invalid_unsigned_int; }))
          {
            const auto corners = corners_of<dim>(simplex, points);
            double longest     = 0.;
            for (unsigned int a = 0; a <= dim; ++a)
              for (unsigned int b = 0; b < a; ++b)
                longest = std::max(longest, corners[a].distance(corners[b]));
            is_known = is_known && signed_volume<dim>(corners) > flat * std::pow(longest, dim);
            if (!is_known)
              break;
            const Tensor<1, dim> to_centre = to_circumcentre<dim>(corners);
            const double radius            = (1. + margin) * to_centre.norm();
            const Point<dim> centre        = corners[0] + to_centre;
            BoundingBox<dim> ball({centre, centre});
            ball.extend(radius);
            const auto &[lower, upper] = ball.get_boundary_points();
            if (!box.point_inside(lower, 0.) || !box.point_inside(upper, 0.))
            {
              box.merge_with(ball);
              changed = true;
            }
          }
        // The faces opposite to an inner point are a closed surface: as many as it has corners (in space twice that,
        // but for four).
        std::vector<bool> is_closed(wanted.size(), false);
        for_each_star(simplices, [&](const unsigned int k, const std::vector<unsigned int> &others) {
          unsigned int n_corners = 0;
          for (unsigned int i = 0; i < others.size(); ++i)
            n_corners += (i == 0 || others[i] != others[i - 1]);
          const unsigned int n_faces = others.size() / dim;
          is_closed[k]               = n_faces == (dim == 2 ? n_corners : 2 * n_corners - 4);
        });
        is_known = is_known && std::find(is_closed.begin(), is_closed.end(), false) == is_closed.end();
        if (!is_known)
        {
          std::vector<unsigned int> all(points.size());
          std::iota(all.begin(), all.end(), 0U);
          box.merge_with(box_of(points, all));
        }
        return changed || !is_known;
      }

      const std::vector<Point<dim>> &points;
      const std::vector<unsigned int> &wanted;
      std::vector<unsigned int> number; ///< by point, in the list of those that are wanted
    };
  } // namespace



  template <int dim>
  void smooth(const Smoothing<dim> &smoothing, const MPI_Comm &communicator, std::vector<Point<dim>> &points)
  {
    for (unsigned int sweep = 0; sweep < smoothing.n_sweeps; ++sweep)
    {
      std::vector<unsigned int> part;
      for (unsigned int i = 0; i < points.size(); ++i)
        if (smoothing.may_move(i, points[i]))
          part.push_back(i);
      part           = part_of(points, std::move(part), Utilities::MPI::this_mpi_process(communicator),
                               Utilities::MPI::n_mpi_processes(communicator));
      double largest = 0.;
      for (const unsigned int i : part)
        largest = std::max(largest, smoothing.h(points[i]));

      std::vector<double> moved; // index and new place, one point behind the other
      const auto move = [&](const unsigned int k, const std::vector<unsigned int> &neighbours) {
        const Point<dim> &p = points[part[k]];
        Tensor<1, dim> sum;
        double weights = 0.;
        for (auto begin = neighbours.begin(); begin != neighbours.end();)
        {
          const auto end      = std::upper_bound(begin, neighbours.end(), *begin);
          const Point<dim> &q = points[*begin];
          const double weight = (end - begin) * smoothing.coarsest / smoothing.h(p + 0.5 * (q - p));
          sum += weight * Tensor<1, dim>(q);
          weights += weight;
          begin = end;
        }
        if (const Point<dim> mean(sum / weights); weights > 0. && smoothing.may_stand(mean))
        {
          moved.push_back(part[k]);
          for (unsigned int d = 0; d < dim; ++d)
            moved.push_back(mean[d]);
        }
      };
      if (!part.empty())
        LocalStars<dim>(points, part).for_each(first_margin * largest, move);
      for (const std::vector<double> &of_rank : Utilities::MPI::all_gather(communicator, moved))
        for (auto value = of_rank.begin(); value != of_rank.end(); value += dim + 1)
          std::copy_n(value + 1, dim, &points[static_cast<unsigned int>(*value)][0]);
    }
  }



  template void smooth(const Smoothing<2> &, const MPI_Comm &, std::vector<Point<2>> &);
  template void smooth(const Smoothing<3> &, const MPI_Comm &, std::vector<Point<3>> &);
} // namespace Lahar
