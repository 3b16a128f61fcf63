// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/graded_points.h>
#include <lahar/geometry/lattice.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/smoothing.h>
#include <lahar/utilities/share_of_rank.h>

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

    /// Sweeps of the smoothing.
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

      /// The wanted points inside the body: of them this rank's share.
      std::vector<Point<3>> points(const MPI_Comm &communicator)
      {
        Place first{{0, 0, 0}}, last;
        for (unsigned int d = 0; d < 3; ++d)
          last[d] = std::ceil((box.upper[d] - box.lower[d]) / half);
        const auto [begin, end] = share_of_rank(last[0] + 1, communicator);
        places.clear();
        if (begin == end)
          return {};
        first[0] = begin;
        last[0]  = end - 1;
        search(first, last);
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
  } // namespace



  DividedPoints<3> fill_inside(const FluidBody<3> &body, const std::vector<Point<3>> &contour,
                               const MeshSize<3> &h, const MPI_Comm &communicator)
  {
    std::vector<Point<3>> of_contour;
    PointSet<3> places;
    for (const Point<3> &p : contour)
      if (places.insert_if_free(p, 0.5 * h(p)))
        of_contour.push_back(p);

    DividedPoints<3> points = with_graded_lattice<3>(
      of_contour, h, h.levels(),
      [&](const double size, const PointFilter<3> &is_wanted) {
        return BodyLattice(body, size, is_wanted).points(communicator);
      },
      communicator);
    // Where h is the same everywhere, those near the contour move.
    const auto may_move = [&](const unsigned int number, const Point<3> &p) {
      return number >= of_contour.size() && (!h.is_uniform() || body.signed_distance(p) > -2. * h.coarsest());
    };
    const auto may_stand = [&](const Point<3> &p) { return body.signed_distance(p) < -0.5 * h(p); };
    smooth<3>({n_sweeps, h, h.coarsest(), may_move, may_stand}, communicator, points);
    return points;
  }
} // namespace Lahar
