// SPDX-License-Identifier: GPL-3.0-or-later

// Test the smoothing of a body's points: it is what its formula says, of bodies whose simplices are flat or long, too,
// and to the last bit the same on any number of ranks.

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/smoothing.h>

#include "../tests.h"

using namespace Tests;

template <int dim>
using Points = std::vector<Point<dim>>;

/// The formula, from all points' triangulation.
template <int dim>
Points<dim> smoothed(const Smoothing<dim> &smoothing, Points<dim> points)
{
  for (unsigned int sweep = 0; sweep < smoothing.n_sweeps; ++sweep)
  {
    std::vector<Tensor<1, dim>> sum(points.size());
    std::vector<double> weights(points.size(), 0.);
    for (const Simplex<dim> &simplex : delaunay(points))
      for (const unsigned int a : simplex)
        for (const unsigned int b : simplex)
          if (a != b)
          {
            const double weight = smoothing.coarsest / smoothing.h(points[a] + 0.5 * (points[b] - points[a]));
            sum[a] += weight * Tensor<1, dim>(points[b]);
            weights[a] += weight;
          }
    for (unsigned int i = 0; i < points.size(); ++i)
      if (smoothing.may_move(i, points[i]) && weights[i] > 0.)
        if (const Point<dim> mean(sum[i] / weights[i]); smoothing.may_stand(mean))
          points[i] = mean;
  }
  return points;
}

/// By smooth(), each rank having a part of the points.
template <int dim>
Points<dim> smoothed(const Smoothing<dim> &smoothing, const Points<dim> &points, const MPI_Comm &communicator)
{
  DividedPoints<dim> part;
  for (unsigned int i = 0; i < points.size() && Utilities::MPI::this_mpi_process(communicator) == 0; ++i)
    part.append(points[i], i);
  divide(part, communicator);
  smooth<dim>(smoothing, communicator, part);
  return all_points(part, communicator);
}

template <int dim>
void test(const std::string &name, const Smoothing<dim> &smoothing, const Points<dim> &points)
{
  const Points<dim> alone    = smoothed<dim>(smoothing, points, MPI_COMM_SELF),
                    on_ranks = smoothed<dim>(smoothing, points, MPI_COMM_WORLD);
  const Points<dim> expected = smoothed<dim>(smoothing, points);
  double error               = 0.;
  unsigned int n_moved       = 0;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    error = std::max(error, alone[i].distance(expected[i]));
    n_moved += alone[i] != points[i];
  }
  check(name + ": some points move, some do not", n_moved > 0 && n_moved < points.size());
  check(name + ": the formula", error, 1e-12);
  check(name + ": to the last bit the same on all ranks", alone == on_ranks);
}

/// Points of a lattice in a box, a little moved, in no special order.
template <int dim>
Points<dim> lattice(const std::array<unsigned int, dim> &n, const double disorder)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> aside(-disorder, disorder);
  Points<dim> points;
  unsigned int n_all = 1;
  for (const unsigned int in_direction : n)
    n_all *= in_direction;
  for (unsigned int i = 0; i < n_all; ++i)
  {
    Point<dim> p;
    unsigned int rest = i;
    for (unsigned int d = 0; d < dim; rest /= n[d++])
      p[d] = rest % n[d] + aside(random);
    points.push_back(p);
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

template <int dim>
void test_shapes(const std::string &where, const std::array<unsigned int, dim> &long_box,
                 const std::array<unsigned int, dim> &wide_box)
{
  const auto uniform  = [](const Point<dim> &) { return 1.; };
  const auto graded   = [](const Point<dim> &p) { return 1. + 0.1 * p[0]; };
  const auto anywhere = [](const Point<dim> &) { return true; };
  // All but every seventh: also points of the convex hull, whose stars are open.
  const auto most = [](const unsigned int i, const Point<dim> &) { return i % 7 != 0; };
  const std::vector<std::pair<std::string, std::array<unsigned int, dim>>> boxes = {{"long box", long_box},
                                                                                    {"wide box", wide_box}};
  for (const auto &[box, n] : boxes)
  {
    test<dim>(where + ", " + box, {3, uniform, 1., most, anywhere}, lattice<dim>(n, 0.3));
    test<dim>(where + ", " + box + ", graded", {3, graded, 3., most, anywhere}, lattice<dim>(n, 0.3));
    // Points inside only, from a lattice with many points on one sphere.
    const auto inside = [n = n](const unsigned int, const Point<dim> &p) {
      for (unsigned int d = 0; d < dim; ++d)
        if (p[d] < 0.5 || p[d] > n[d] - 1.5)
          return false;
      return true;
    };
    test<dim>(where + ", " + box + ", inside, regular", {1, graded, 3., inside, anywhere},
              lattice<dim>(n, 0.));
    test<dim>(where + ", " + box + ", inside", {3, uniform, 1., inside, anywhere}, lattice<dim>(n, 0.2));
    const auto half = [](const Point<dim> &p) { return p[0] < 3.; };
    test<dim>(where + ", " + box + ", not everywhere", {3, uniform, 1., most, half}, lattice<dim>(n, 0.3));
  }
  // Two bodies far apart: circumballs reach from one to the other.
  Points<dim> two = lattice<dim>(wide_box, 0.3);
  for (Point<dim> p : lattice<dim>(wide_box, 0.2))
  {
    p[0] += 50.;
    two.push_back(p);
  }
  test<dim>(where + ", two bodies", {2, uniform, 1., most, anywhere}, two);
  two.push_back(two[1]);
  test<dim>(where + ", two points in one place", {2, uniform, 1., most, anywhere}, two);
}

int main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_shapes<2>("plane", {{60, 4}}, {{21, 19}});
  test_shapes<3>("space", {{30, 4, 3}}, {{11, 9, 7}});
  return n_failed > 0;
}
