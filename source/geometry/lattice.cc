#include <lahar/geometry/lattice.h>
#include <lahar/geometry/point_set.h>
#include <lahar/remeshing/delaunay.h>

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

    /// Move every point but the first @p n_fixed towards the mean of its Delaunay neighbours, a few times.
    void smooth(const FluidBody<3> &body, const unsigned int n_fixed, const double h,
                std::vector<Point<3>> &points)
    {
      for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      {
        std::vector<Tensor<1, 3>> sum(points.size());
        std::vector<unsigned int> n_neighbours(points.size(), 0);
        for (const Simplex<3> &cell : delaunay(points))
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int b = 0; b < 4; ++b)
              if (a != b)
              {
                sum[cell[a]] += Tensor<1, 3>(points[cell[b]]);
                ++n_neighbours[cell[a]];
              }
        for (unsigned int i = n_fixed; i < points.size(); ++i)
        {
          const Point<3> mean(sum[i] / n_neighbours[i]);
          if (body.signed_distance(points[i]) > -2. * h && body.signed_distance(mean) < -0.5 * h)
            points[i] = mean;
        }
      }
    }
  } // namespace



  std::vector<Point<3>> fill_inside(const FluidBody<3> &body, const std::vector<Point<3>> &contour,
                                    const double h)
  {
    std::vector<Point<3>> points;
    PointSet<3> places;
    for (const Point<3> &p : contour)
      if (places.insert_if_free(p, 0.5 * h))
        points.push_back(p);
    const unsigned int n_contour = points.size();

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
          if (body.signed_distance(p) < -clearance * h)
            points.push_back(p);
        }
    smooth(body, n_contour, h, points);
    return points;
  }
} // namespace Lahar
