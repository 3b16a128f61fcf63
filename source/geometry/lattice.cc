// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/graded_points.h>
#include <lahar/geometry/lattice.h>
#include <lahar/geometry/point_set.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Lahar
{
  namespace
  {
    /// Lattice constant over h: eight edges of √3/2 of it and six of 1 of it meet in a point; their mean is h.
    const double lattice_constant = 14. / (8. * std::sqrt(0.75) + 6.);

    /// Lattice points stay away from the contour by this times h.
    constexpr double contour_clearance = 0.6;

    constexpr unsigned int n_sweeps = 5;

    using Place = std::array<unsigned int, 3>;

    /// The lattice around a body.
    class BodyLattice
    {
    public:
      BodyLattice(const FluidBody<3> &body, const double h, const PointFilter<3> &is_wanted)
        : body(body)
        , h(h)
        , is_wanted(is_wanted)
        , box(body.box())
      {}

      /// The wanted points inside the body.
      std::vector<Point<3>> points()
      {
        Place last;
        for (unsigned int d = 0; d < 3; ++d)
          last[d] = std::ceil((box.upper[d] - box.lower[d]) / half);
        places.clear();
        search({{0, 0, 0}}, last);
        std::sort(places.begin(), places.end());
        std::vector<Point<3>> result;
        for (const Place &place : places)
          result.push_back(point(place));
        return result;
      }

    private:
      /// So many places, of which a fourth are points of the lattice, are looked at one by one.
      static constexpr double n_few = 256.;

      Point<3> point(const Place &place) const
      {
        return box.lower + half * Tensor<1, 3>({double(place[0]), double(place[1]), double(place[2])});
      }

      /// Append what is inside from @p first to @p last, both included, of which most lie outside if the body is long,
      /// thin and oblique: parts whose middle is farther outside than any of their points are passed over.
      void search(const Place &first, const Place &last)
      {
        double n             = 1.;
        unsigned int longest = 0;
        for (unsigned int d = 0; d < 3; ++d)
        {
          n *= last[d] - first[d] + 1.;
          if (last[d] - first[d] > last[longest] - first[longest])
            longest = d;
        }
        if (n <= n_few)
        {
          for (unsigned int i = first[0]; i <= last[0]; ++i)
            for (unsigned int j = first[1] + (first[1] + i) % 2; j <= last[1]; j += 2)
              for (unsigned int k = first[2] + (first[2] + i) % 2; k <= last[2]; k += 2)
              {
                const Point<3> p = point({{i, j, k}});
                if (is_wanted(p) && body.signed_distance(p) < -contour_clearance * h)
                  places.push_back({{i, j, k}});
              }
          return;
        }
        const Point<3> begin = point(first), end = point(last);
        if (body.signed_distance(begin + 0.5 * (end - begin)) > 0.5001 * begin.distance(end))
          return;
        Place middle = last, next = first;
        middle[longest] = first[longest] + (last[longest] - first[longest]) / 2;
        next[longest]   = middle[longest] + 1;
        search(first, middle);
        search(next, last);
      }

      const FluidBody<3> &body;
      double h;
      const PointFilter<3> &is_wanted;
      Box<3> box;
      double half = 0.5 * lattice_constant * h; ///< of the lattice constant
      std::vector<Place> places;
    };

    /// Move points towards the mean of their Delaunay neighbours, a few times, weighted by h_0/h, h_0 the largest h: all
    /// but the first @p n_fixed where h changes with the place, those near the contour where it is the same everywhere.
    void smooth(const FluidBody<3> &body, const unsigned int n_fixed, const MeshSize<3> &h,
                std::vector<Point<3>> &points)
    {
      for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      {
        std::vector<Tensor<1, 3>> sum(points.size());
        std::vector<double> weights(points.size(), 0.);
        for (const Simplex<3> &cell : delaunay(points))
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int b = 0; b < 4; ++b)
              if (a != b)
              {
                const Point<3> &p = points[cell[a]], &q = points[cell[b]];
                const double weight = h.coarsest() / h(p + 0.5 * (q - p));
                sum[cell[a]] += weight * Tensor<1, 3>(q);
                weights[cell[a]] += weight;
              }
        for (unsigned int i = n_fixed; i < points.size(); ++i)
        {
          const Point<3> mean(sum[i] / weights[i]);
          if ((!h.is_uniform() || body.signed_distance(points[i]) > -2. * h.coarsest()) &&
              body.signed_distance(mean) < -0.5 * h(mean))
            points[i] = mean;
        }
      }
    }
  } // namespace



  std::vector<Point<3>> fill_inside(const FluidBody<3> &body, const std::vector<Point<3>> &contour,
                                    const MeshSize<3> &h)
  {
    std::vector<Point<3>> points;
    PointSet<3> places;
    for (const Point<3> &p : contour)
      if (places.insert_if_free(p, 0.5 * h(p)))
        points.push_back(p);
    const unsigned int n_contour = points.size();

    append_graded_lattice<3>(
      h, h.levels(),
      [&](const double size, const PointFilter<3> &is_wanted) {
        return BodyLattice(body, size, is_wanted).points();
      },
      points);
    smooth(body, n_contour, h, points);
    return points;
  }
} // namespace Lahar
