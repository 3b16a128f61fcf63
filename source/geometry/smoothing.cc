// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/smoothing.h>
#include <lahar/utilities/in_buckets.h>
#include <lahar/utilities/true_on_all_ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

    /// The Delaunay neighbours of some points among all of them, from a triangulation of what is around them.
    template <int dim>
    class LocalStars
    {
    public:
      /// Of the points of this rank with the indices @p wanted, ascending. @p distance (m) around them is looked at
      /// first. Collective.
      LocalStars(const DividedPoints<dim> &points, const std::vector<unsigned int> &wanted,
                 const double distance, const MPI_Comm &communicator)
        : n_wanted(wanted.size())
      {
        std::vector<Point<dim>> places;
        for (const unsigned int i : wanted)
          places.push_back(points.position[i]);
        std::optional<BoundingBox<dim>> box = bounding_box(places);
        if (box)
          box->extend(distance);
        // A star is that of all points if it is closed and no other point lies in the balls of its simplices.
        const BoundingBox<dim> whole = box_around_all(points, communicator);
        const std::size_t n_all      = Utilities::MPI::sum(points.size(), communicator);
        for (bool done = false; !done;)
        {
          KnownPoints<dim> known = points_in(box, points, communicator);
          if (box)
          {
            region = std::move(known);
            find_wanted(points, wanted);
            simplices = delaunay(region.position);
            if (region.size() == n_all || !extend(whole, *box))
              box.reset();
          }
          done = true_on_all_ranks(!box, communicator);
        }
      }

      /// What is around, in the order of the numbers.
      const std::vector<Point<dim>> &position() const
      {
        return region.position;
      }

      /// Call @p action for each of the points with its place in the list and its neighbours, ascending indices of
      /// position(), each of them as often as both share simplices.
      template <typename Action>
      void for_each(const Action &action) const
      {
        const auto for_each_pair = [&](const auto &visit) {
          for (const Simplex<dim> &simplex : simplices)
            for (const unsigned int i : simplex)
              if (is_wanted(i))
                for (const unsigned int other : simplex)
                  if (other != i)
                    visit(place[i], other);
        };
        in_buckets(n_wanted, for_each_pair, [&](const unsigned int k, std::vector<unsigned int> &others) {
          std::sort(others.begin(), others.end());
          action(k, others);
        });
      }

    private:
      static BoundingBox<dim> box_around_all(const DividedPoints<dim> &points, const MPI_Comm &communicator)
      {
        // Their lower and their negative upper bounds.
        std::vector<double> bounds(2 * dim, std::numeric_limits<double>::max());
        for (const Point<dim> &p : points.position)
          for (unsigned int d = 0; d < dim; ++d)
          {
            bounds[d]       = std::min(bounds[d], p[d]);
            bounds[dim + d] = std::min(bounds[dim + d], -p[d]);
          }
        Utilities::MPI::min(bounds, communicator, bounds);
        std::pair<Point<dim>, Point<dim>> corners;
        for (unsigned int d = 0; d < dim; ++d)
        {
          corners.first[d]  = bounds[d];
          corners.second[d] = std::max(bounds[d], -bounds[dim + d]); // also of no points
        }
        return BoundingBox<dim>(corners);
      }

      void find_wanted(const DividedPoints<dim> &points, const std::vector<unsigned int> &wanted)
      {
        place.assign(region.size(), numbers::invalid_unsigned_int);
        for (unsigned int k = 0, i = 0; k < wanted.size(); ++k)
        {
          while (region.number[i] != points.number[wanted[k]])
            ++i;
          place[i] = k;
        }
      }

      bool is_wanted(const unsigned int i) const
      {
        return place[i] != numbers::invalid_unsigned_int;
      }

      /// Extend the box by what the wanted stars depend on, at most to @p whole. @return whether there is such.
      bool extend(const BoundingBox<dim> &whole, BoundingBox<dim> &box) const
      {
        bool is_known = true, changed = false;
        for (const Simplex<dim> &simplex : simplices)
          if (std::any_of(simplex.begin(), simplex.end(), [&](const unsigned int i) { return is_wanted(i); }))
          {
            const auto corners = corners_of<dim>(simplex, region.position);
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
        std::vector<bool> is_closed(n_wanted, false);
        for_each([&](const unsigned int k, const std::vector<unsigned int> &others) {
          unsigned int n_corners = 0;
          for (unsigned int i = 0; i < others.size(); ++i)
            n_corners += (i == 0 || others[i] != others[i - 1]);
          const unsigned int n_faces = others.size() / dim;
          is_closed[k]               = n_faces == (dim == 2 ? n_corners : 2 * n_corners - 4);
        });
        is_known = is_known && std::find(is_closed.begin(), is_closed.end(), false) == is_closed.end();
        if (!is_known)
          box.merge_with(whole);
        return changed || !is_known;
      }

      unsigned int n_wanted;
      DividedPoints<dim> region;
      std::vector<unsigned int> place; ///< by index in the region, in the list of those that are wanted
      std::vector<Simplex<dim>> simplices;
    };
  } // namespace



  template <int dim>
  void smooth(const Smoothing<dim> &smoothing, const MPI_Comm &communicator, DividedPoints<dim> &points)
  {
    for (unsigned int sweep = 0; sweep < smoothing.n_sweeps; ++sweep)
    {
      std::vector<unsigned int> wanted;
      double largest = 0.;
      for (unsigned int i = 0; i < points.size(); ++i)
        if (smoothing.may_move(points.number[i], points.position[i]))
        {
          wanted.push_back(i);
          largest = std::max(largest, smoothing.h(points.position[i]));
        }
      const LocalStars<dim> stars(points, wanted, first_margin * largest, communicator);
      const std::vector<Point<dim>> &around = stars.position();
      stars.for_each([&](const unsigned int k, const std::vector<unsigned int> &neighbours) {
        Point<dim> &p = points.position[wanted[k]];
        Tensor<1, dim> sum;
        double weights = 0.;
        for (auto begin = neighbours.begin(); begin != neighbours.end();)
        {
          const auto end      = std::upper_bound(begin, neighbours.end(), *begin);
          const Point<dim> &q = around[*begin];
          const double weight = (end - begin) * smoothing.coarsest / smoothing.h(p + 0.5 * (q - p));
          sum += weight * Tensor<1, dim>(q);
          weights += weight;
          begin = end;
        }
        if (const Point<dim> mean(sum / weights); weights > 0. && smoothing.may_stand(mean))
          p = mean;
      });
    }
  }



  template void smooth(const Smoothing<2> &, const MPI_Comm &, DividedPoints<2> &);
  template void smooth(const Smoothing<3> &, const MPI_Comm &, DividedPoints<3> &);
} // namespace Lahar
