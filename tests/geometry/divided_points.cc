// SPDX-License-Identifier: GPL-3.0-or-later

// Test points of which each rank has a part: what all ranks find is what one finds that has them all; a body's points
// are divided among the ranks from the first on.

#include <lahar/geometry/cone_body.h>
#include <lahar/geometry/take_places.h>

#include "../tests.h"

using namespace Tests;

template <int dim>
using Points = std::vector<Point<dim>>;

/// The points with the numbers 3 i, divided among the ranks.
template <int dim>
DividedPoints<dim> divided(const Points<dim> &points)
{
  DividedPoints<dim> part;
  for (unsigned int i = 0; i < points.size(); ++i)
    if (i % Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) ==
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
      part.append(points[i], 3 * i);
  divide(part, MPI_COMM_WORLD);
  return part;
}

template <int dim>
Points<dim> random_points(const unsigned int n)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0., 1.);
  Points<dim> points(n);
  for (Point<dim> &p : points)
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = place(random);
  return points;
}

template <int dim>
void test_queries()
{
  const std::string where       = dim == 2 ? "plane: " : "space: ";
  const unsigned int n_ranks    = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const Points<dim> points      = random_points<dim>(1000);
  const DividedPoints<dim> part = divided(points);
  check(where + "each rank has its part of the points", std::abs(part.size() - 1000. / n_ranks) < 20.);
  check(where + "all of them in order", all_points(part, MPI_COMM_WORLD) == points);
  check(where + "end of the numbers", end_of_numbers(part, MPI_COMM_WORLD) == 2998);

  // The box of each rank is another one.
  BoundingBox<dim> box({points[0], points[0]});
  box.extend(0.1 * (1 + Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)));
  const KnownPoints<dim> known = points_in<dim>(box, part, MPI_COMM_WORLD);
  bool same                    = true;
  unsigned int n               = 0;
  for (unsigned int i = 0; i < points.size(); ++i)
    if (box.point_inside(points[i]))
    {
      same = same && n < known.size() && known.number[n] == 3 * i && known.position[n] == points[i];
      ++n;
    }
  check(where + "points in a box", same && n == known.size() && n > 1);
  unsigned int n_own = 0;
  for (unsigned int i = 0; i < known.size(); ++i)
    if (known.owner[i] == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
      n_own += std::find(part.number.begin(), part.number.end(), known.number[i]) != part.number.end() ? 1
                                                                                                       : 1000;
  unsigned int n_expected = 0;
  for (const Point<dim> &p : part.position)
    n_expected += box.point_inside(p);
  check(where + "and their owners", n_own == n_expected);
  check(where + "no points in no box", points_in<dim>({}, part, MPI_COMM_WORLD).size() == 0);

  const auto is_right = [](const Point<dim> &p) { return p[0] > 0.8; };
  const auto first    = first_of<dim>(part, is_right, MPI_COMM_WORLD);
  check(where + "the first of some",
        first && *first == *std::find_if(points.begin(), points.end(), is_right));
  check(where + "the first of none", !first_of<dim>(
                                       part, [](const Point<dim> &p) { return p[0] > 2.; }, MPI_COMM_WORLD));

  DividedPoints<dim> right = part;
  right.keep_if([&](const std::size_t i) { return is_right(right.position[i]); });
  renumber(right, 7, MPI_COMM_WORLD);
  Points<dim> expected;
  std::copy_if(points.begin(), points.end(), std::back_inserter(expected), is_right);
  for (unsigned int i = 0; i < right.size(); ++i)
    same = same && right.number[i] >= 7 && right.position[i] == expected[right.number[i] - 7];
  check(where + "new numbers without gaps",
        same && Utilities::MPI::sum(right.size(), MPI_COMM_WORLD) == expected.size());
}

/// Of those that take their places one after the other; every third keeps half the distance from others.
template <int dim>
void test_places(const std::string &name, const Points<dim> &points, const double clearance)
{
  const auto clearance_at = [&](const Point<dim> &p) { return clearance * (1. + p[0]); };
  const auto in_the_way   = [&](const Point<dim> &p, const unsigned int number, const Point<dim> &q,
                              const unsigned int) {
    return number % 9 != 0 || p.distance(q) < 0.5 * clearance_at(p);
  };
  const auto is_free = [](const Point<dim> &p) { return p[dim - 1] < 0.9; };
  std::vector<bool> expected;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    expected.push_back(is_free(points[i]));
    for (unsigned int j = 0; j < i; ++j)
      if (expected[j] && points[i].distance(points[j]) < clearance_at(points[i]) &&
          in_the_way(points[i], 3 * i, points[j], 3 * j))
        expected[i] = false;
  }
  const unsigned int n_standing = std::count(expected.begin(), expected.end(), true);
  check(name + ": many stand, many do not", n_standing > 20 && points.size() - n_standing > 20);

  const DividedPoints<dim> part = divided(points);
  std::vector<bool> free;
  for (const Point<dim> &p : part.position)
    free.push_back(is_free(p));
  const std::vector<bool> stands = take_places<dim>(part, free, clearance_at, in_the_way, MPI_COMM_WORLD);
  bool same                      = stands.size() == part.size();
  for (unsigned int i = 0; i < part.size() && same; ++i)
    same = stands[i] == expected[part.number[i] / 3];
  check(name + ": the same that stand one after the other", same);
}

int main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_queries<2>();
  test_queries<3>();
  test_places<2>("plane", random_points<2>(2000), 0.04);
  test_places<3>("space", random_points<3>(2000), 0.1);
  // Each depends on the one before it, from the first rank to the last one and back.
  Points<2> row;
  for (unsigned int i = 0; i < 200; ++i)
    row.emplace_back(1e-3 * i, 0.);
  for (unsigned int i = 0; i < 200; ++i)
    row.emplace_back(0.1995 - 1e-3 * i, 1e-3);
  test_places<2>("a row", row, 0.0012);

  const ConeBody cone("mud", Point<3>(), Point<3>(0., 0., 1.), 1., 0.5);
  MeshSize<3> h               = 0.1;
  const DividedPoints<3> part = cone.fill(h, MPI_COMM_WORLD), alone = cone.fill(h, MPI_COMM_SELF);
  check("a cone on ranks: to the last bit, in the same order",
        all_points(part, MPI_COMM_WORLD) == alone.position);
  check("a cone on ranks: each has its part of the points",
        part.size() < 1.1 * alone.size() / Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  return n_failed > 0;
}
