// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/graded_points.h>
#include <lahar/geometry/lattice.h>
#include <lahar/geometry/point_set.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    /// Lattice constant over h: eight edges of √3/2 of it and six of 1 of it meet in a point; their mean is h.
    const double lattice_constant = 14. / (8. * std::sqrt(0.75) + 6.);

    /// Lattice points stay away from the contour by this times h.
    constexpr double clearance = 0.6;

    constexpr unsigned int n_sweeps = 5;

    /// The wanted points of the lattice inside the body.
    std::vector<Point<3>> lattice_inside(const FluidBody<3> &body, const double h,
                                         const PointFilter<3> &is_wanted)
    {
      std::vector<Point<3>> points;
      const double a   = lattice_constant * h;
      const Box<3> box = body.box();
      std::array<unsigned int, 3> n;
      for (unsigned int d = 0; d < 3; ++d)
        n[d] = std::ceil((box.upper[d] - box.lower[d]) / (0.5 * a));
      for (unsigned int i = 0; i <= n[0]; ++i)
        for (unsigned int j = i % 2; j <= n[1]; j += 2)
          for (unsigned int k = i % 2; k <= n[2]; k += 2)
          {
            const Point<3> p = box.lower + 0.5 * a * Tensor<1, 3>({double(i), double(j), double(k)});
            if (is_wanted(p) && body.signed_distance(p) < -clearance * h)
              points.push_back(p);
          }
      return points;
    }

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
        return lattice_inside(body, size, is_wanted);
      },
      points);
    smooth(body, n_contour, h, points);
    return points;
  }
} // namespace Lahar
