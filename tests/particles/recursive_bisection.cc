// SPDX-License-Identifier: GPL-3.0-or-later

// Test the division of space among the ranks: all have their share of the weight, wherever the points are and whichever
// rank has told of them; all ranks agree; parts are convex in every direction; points that cannot be divided do no harm.

#include <lahar/particles/recursive_bisection.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

/// Divide space by the points, each told by the rank that @p on_rank names.
template <int dim, typename F>
void test(const std::string &name, const std::vector<Point<dim>> &points, const std::vector<double> &weights,
          const F &on_rank, const double tolerance)
{
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     rank    = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  std::vector<Point<dim>> own_points;
  std::vector<double> own_weights;
  for (unsigned int i = 0; i < points.size(); ++i)
    if (on_rank(i) == rank)
    {
      own_points.push_back(points[i]);
      own_weights.push_back(weights[i]);
    }
  RecursiveBisection<dim> parts(MPI_COMM_WORLD);
  check(name + "at first all is the first rank's", parts.rank_of(points[0]) == 0);
  parts.divide(own_points, own_weights);

  double all = 0.;
  std::vector<double> shares(n_ranks, 0.), owners;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    owners.push_back(parts.rank_of(points[i]));
    shares[parts.rank_of(points[i])] += weights[i];
    all += weights[i];
  }
  const double largest = *std::max_element(shares.begin(), shares.end());
  check(name + "largest share of the weight", std::max(0., largest / all * n_ranks - 1.), tolerance);
  std::vector<double> greatest(owners.size());
  Utilities::MPI::max(owners, MPI_COMM_WORLD, greatest);
  check(name + "the ranks agree", owners == greatest);

  // What lies between two points of one part is the same rank's.
  bool convex = true;
  for (unsigned int i = 0; i + 7 < points.size(); i += 3)
    if (owners[i] == owners[i + 7])
      convex = convex && parts.rank_of(points[i] + 0.3 * (points[i + 7] - points[i])) == owners[i];
  check(name + "parts are convex", convex);
}

template <int dim>
void test_all()
{
  const std::string name     = std::to_string(dim) + "D, ";
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  Random random;
  std::vector<Point<dim>> points;
  std::vector<double> weights, equal;
  for (unsigned int i = 0; i < 20000; ++i)
  {
    points.push_back(Point<dim>(random.vector<dim>()));
    points.back()[1] *= 0.2;
    weights.push_back(1. + 20. * std::max(0., points.back()[0])); // more work on one side
    equal.push_back(1.);
  }
  // Half a percent in each of the up to two or three cuts.
  const auto shared_out = [&](const unsigned int i) { return i % n_ranks; };
  const auto on_first   = [](const unsigned int) { return 0U; };
  test<dim>(name + "equal weights: ", points, equal, shared_out, 0.02);
  test<dim>(name + "different weights: ", points, weights, shared_out, 0.02);
  test<dim>(name + "told by one rank: ", points, weights, on_first, 0.02);
  std::vector<Point<dim>> lattice;
  for (unsigned int i = 0; i < 100; ++i)
    for (unsigned int j = 0; j < 10; ++j)
    {
      lattice.emplace_back();
      lattice.back()[0] = i;
      lattice.back()[1] = j;
    }
  test<dim>(name + "lattice: ", lattice, std::vector<double>(lattice.size(), 1.), shared_out, 0.08);
  // Somebody has all of what is in one place.
  test<dim>(name + "all in one place: ", std::vector<Point<dim>>(50), std::vector<double>(50, 1.), shared_out,
            n_ranks - 1.);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_all<2>();
  test_all<3>();
  return n_failed > 0;
}
