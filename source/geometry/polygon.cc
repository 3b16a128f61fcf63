// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/polygon.h>
#include <lahar/geometry/smoothing.h>
#include <lahar/utilities/share_of_rank.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/geometries/segment.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Lahar
{
  namespace
  {
    namespace bg = boost::geometry;

    using BoostPoint   = bg::model::d2::point_xy<double>;
    using BoostPolygon = bg::model::polygon<BoostPoint, false, false>; // counterclockwise, open

    BoostPoint to_boost(const Point<2> &p)
    {
      return {p[0], p[1]};
    }

    BoostPolygon to_boost(const Polygon &polygon)
    {
      BoostPolygon result;
      for (const Point<2> &p : polygon)
        bg::append(result, to_boost(p));
      return result;
    }

    /// What is left of the contour when the points of a lattice are looked for, over h.
    constexpr double grid_clearance = 0.55;

    /// Sweeps of the smoothing.
    constexpr unsigned int n_sweeps = 10;

    /// A lattice of equilateral triangles in the box around a contour.
    class ContourLattice
    {
    public:
      ContourLattice(const std::vector<Point<2>> &contour, const SizeFunction<2> &depth, const double h,
                     const PointFilter<2> &is_wanted)
        : depth(depth)
        , h(h)
        , is_wanted(is_wanted)
      {
        double lower[2], upper[2];
        for (unsigned int d = 0; d < 2; ++d)
        {
          lower[d] = upper[d] = contour[0][d];
          for (const Point<2> &p : contour)
          {
            lower[d] = std::min(lower[d], p[d]);
            upper[d] = std::max(upper[d], p[d]);
          }
        }

        const double row_height = std::sqrt(0.75) * h;
        for (unsigned int row = 0; row == 0 || lower[1] + row * row_height < upper[1]; ++row)
          y.push_back(lower[1] + row * row_height);
        for (const unsigned int parity : {0, 1})
          for (double place = lower[0] + (parity == 1 ? 0.5 : 1.) * h; place < upper[0] && place + h > place;
               place += h)
            x[parity].push_back(place);
      }

      /// The wanted points that are deep enough: of them this rank's share.
      std::vector<Point<2>> points(const MPI_Comm &communicator)
      {
        const auto [begin, end] = share_of_rank(y.size() - 1, communicator);
        places.clear();
        search({{1 + begin, 0}}, {{1 + end, static_cast<unsigned int>(x[1].size())}});
        std::sort(places.begin(), places.end());
        std::vector<Point<2>> result;
        for (const Place &place : places)
          result.push_back(point(place));
        return result;
      }

    private:
      using Place = std::array<unsigned int, 2>; ///< row and number in it

      /// So many places are looked at one by one.
      static constexpr double n_few = 64.;

      Point<2> point(const Place &place) const
      {
        return {x[place[0] % 2][place[1]], y[place[0]]};
      }

      /// Append what is wanted from @p begin to before @p end. Where the contour is long, thin and oblique, most lies
      /// outside: parts whose middle is farther outside than any of their points are passed over.
      void search(const Place &begin, const Place &end)
      {
        if (begin[0] >= end[0] || begin[1] >= end[1])
          return;
        const unsigned int n[2] = {end[0] - begin[0], end[1] - begin[1]};
        if (double(n[0]) * n[1] <= n_few)
        {
          for (unsigned int row = begin[0]; row < end[0]; ++row)
            for (unsigned int i = begin[1]; i < end[1] && i < x[row % 2].size(); ++i)
              if (const Point<2> p = point({{row, i}}); is_wanted(p) && depth(p) > grid_clearance * h)
                places.push_back({{row, i}});
          return;
        }
        // Even rows begin half a step behind the odd ones.
        const Point<2> first(x[1][begin[1]], y[begin[0]]), last(x[1][end[1] - 1] + 0.5 * h, y[end[0] - 1]);
        if (depth(first + 0.5 * (last - first)) < -0.5001 * first.distance(last))
          return;
        const unsigned int direction = n[0] > n[1] ? 0 : 1;
        Place middle = end, next = begin;
        middle[direction] = next[direction] = begin[direction] + n[direction] / 2;
        search(begin, middle);
        search(next, end);
      }

      const SizeFunction<2> &depth;
      double h;
      const PointFilter<2> &is_wanted;
      std::vector<double> y;                ///< of rows, the first of which has no points
      std::array<std::vector<double>, 2> x; ///< in even and in odd rows
      std::vector<Place> places;
    };

    /// Where the pieces of the segment from @p a to @p b begin that are about h long, from 0 to 1.
    std::vector<double> divide(const Point<2> &a, const Point<2> &b, const SizeFunction<2> &h)
    {
      // The integral of ds/h at places so near to each other that h, of a gradient below 1, changes little.
      const double length = a.distance(b);
      std::vector<double> places(1, 0.), integral(1, 0.);
      bool is_constant = true;
      for (double s = 0.; s < length;)
      {
        const double step = std::min(0.05 * h(a + s / length * (b - a)), length - s);
        const double size = h(a + (s + 0.5 * step) / length * (b - a));
        is_constant       = is_constant && size == h(a);
        s                 = (step < length - s ? s + step : length);
        places.push_back(s / length);
        integral.push_back(integral.back() + step / size);
      }
      const unsigned int n = std::max(1., std::round(is_constant ? length / h(a) : integral.back()));
      std::vector<double> result;
      for (unsigned int k = 0, i = 0; k < n; ++k)
        if (is_constant)
          result.push_back(double(k) / n);
        else
        {
          const double wanted = double(k) / n * integral.back();
          while (integral[i + 1] <= wanted)
            ++i;
          result.push_back(places[i] + (wanted - integral[i]) / (integral[i + 1] - integral[i]) *
                                         (places[i + 1] - places[i]));
        }
      return result;
    }
  } // namespace



  double signed_area(const Polygon &polygon)
  {
    return bg::area(to_boost(polygon));
  }



  bool is_inside(const Polygon &polygon, const Point<2> &point)
  {
    bool inside = false;
    for (unsigned int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
      if ((polygon[i][1] > point[1]) != (polygon[j][1] > point[1]) &&
          point[0] <
            (polygon[j][0] - polygon[i][0]) * (point[1] - polygon[i][1]) / (polygon[j][1] - polygon[i][1]) +
              polygon[i][0])
        inside = !inside;
    return inside;
  }



  double distance_to_segment(const Point<2> &point, const Point<2> &a, const Point<2> &b)
  {
    return bg::distance(to_boost(point), bg::model::segment<BoostPoint>(to_boost(a), to_boost(b)));
  }



  double distance_to_contour(const Polygon &polygon, const Point<2> &point)
  {
    double distance = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < polygon.size(); ++i)
      distance = std::min(distance,
                          distance_to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
    return distance;
  }



  bool is_self_intersecting(const Polygon &polygon)
  {
    return bg::intersects(to_boost(polygon));
  }



  std::vector<Point<2>> sample_polyline(const std::vector<Point<2>> &corners, const SizeFunction<2> &h,
                                        const bool closed)
  {
    std::vector<Point<2>> points;
    const unsigned int n_pieces = closed ? corners.size() : corners.size() - 1;
    for (unsigned int i = 0; i < n_pieces; ++i)
    {
      const Point<2> &a = corners[i];
      const Point<2> &b = corners[(i + 1) % corners.size()];
      for (const double s : divide(a, b, h))
        points.push_back(a + s * (b - a));
    }
    if (!closed)
      points.push_back(corners.back());
    return points;
  }



  std::vector<Point<2>> sample_polyline(const std::vector<Point<2>> &corners, const double h,
                                        const bool closed)
  {
    return sample_polyline(
      corners, [h](const Point<2> &) { return h; }, closed);
  }



  DividedPoints<2> fill_contour(const std::vector<Point<2>> &contour, const SizeFunction<2> &depth,
                                const SizeFunction<2> &h, const std::vector<double> &levels,
                                const MPI_Comm &communicator)
  {
    DividedPoints<2> points = with_graded_lattice<2>(
      contour, h, levels,
      [&](const double size, const PointFilter<2> &is_wanted) {
        return ContourLattice(contour, depth, size, is_wanted).points(communicator);
      },
      communicator);
    const auto may_move = [&](const unsigned int number, const Point<2> &) {
      return number >= contour.size();
    };
    const auto may_stand = [](const Point<2> &) { return true; };
    smooth<2>({n_sweeps, h, levels.back(), may_move, may_stand}, communicator, points);
    return points;
  }



  DividedPoints<2> fill_polygon(const Polygon &polygon, const SizeFunction<2> &h,
                                const std::vector<double> &levels, const MPI_Comm &communicator)
  {
    return fill_contour(
      sample_polyline(polygon, h, true),
      [&](const Point<2> &p) {
        const double distance = distance_to_contour(polygon, p);
        return is_inside(polygon, p) ? distance : -distance;
      },
      h, levels, communicator);
  }



  std::vector<Point<2>> fill_polygon(const Polygon &polygon, const double h)
  {
    return fill_polygon(
             polygon, [h](const Point<2> &) { return h; }, {h}, MPI_COMM_SELF)
      .position;
  }
} // namespace Lahar
