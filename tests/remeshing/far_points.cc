// SPDX-License-Identifier: GPL-3.0-or-later

// Test the search for other ranks' particles in circumballs that leave this rank's region: those found lie beyond the
// region and in a ball, none comes twice, and asked until there is no more they are all such particles, as a rank that
// knows all finds them. Balls that lie within the region are not open.

#include <lahar/remeshing/far_points.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

template <int dim>
void test()
{
  const std::string name = std::to_string(dim) + "D: ";
  constexpr double h     = 0.05;
  Random random;
  std::vector<Point<dim>> points;
  ParticleCloud<dim> cloud;
  for (unsigned int i = 0; i < 4000; ++i)
  {
    points.push_back(Point<dim>(random.vector<dim>()));
    points.back()[0] *= 4.;
    cloud.append(points.back(), ParticleKind::fluid, h);
  }
  Migration<dim> migration(MPI_COMM_WORLD);
  migration.distribute(cloud, 4. * h, 0);
  FarPoints<dim> far_points(cloud, migration, h);

  // Flat simplices of own particles: their balls are large.
  std::vector<typename FarPoints<dim>::Query> queries;
  std::vector<unsigned int> own;
  for (unsigned int i = 0; i < cloud.size(); ++i)
    if (cloud.is_own(i))
      own.push_back(i);
  bool small_is_closed = true;
  for (unsigned int k = 0; k < 20 && own.size() > dim + 1; ++k)
  {
    const Point<dim> first = cloud.position[own[(k * own.size()) / 20]];
    small_is_closed        = small_is_closed && !far_points.is_open(first, 2.9 * h);
    SimplexCorners<dim> corners;
    for (unsigned int c = 0; c <= dim; ++c)
    {
      corners[c]          = first + h * random.vector<dim>();
      corners[c][dim - 1] = first[dim - 1] + 0.02 * h * random.number();
    }
    if (signed_volume<dim>(corners) < 0.)
      std::swap(corners[0], corners[1]);
    const Tensor<1, dim> to_centre = to_circumcentre<dim>(corners);
    if (far_points.is_open(corners[0] + to_centre, to_centre.norm()))
      queries.push_back({corners, 3});
  }
  check(name + "small balls of own particles are closed", small_is_closed);
  const bool alone = migration.is_alone();
  check(name + "large ones are open on several ranks",
        alone ? queries.empty() : Utilities::MPI::sum(queries.size(), MPI_COMM_WORLD) > 5);
  if (alone)
    return;

  // All particles of the balls that this rank does not know.
  std::vector<Point<dim>> expected;
  for (unsigned int i = 0; i < points.size(); ++i)
    if (cloud.find(i) == numbers::invalid_unsigned_int &&
        std::any_of(queries.begin(), queries.end(),
                    [&](const auto &query) { return in_circumball<dim>(query.corners, points[i]); }))
      expected.push_back(points[i]);

  const auto before = [](const Point<dim> &a, const Point<dim> &b) { return a[0] < b[0]; };
  std::vector<Point<dim>> found;
  unsigned int n_rounds = 0;
  for (bool any = true; any; ++n_rounds)
  {
    const std::vector<Point<dim>> more = far_points.find(queries);
    found.insert(found.end(), more.begin(), more.end());
    any = Utilities::MPI::max(more.empty() ? 0U : 1U, MPI_COMM_WORLD) == 1U;
  }
  std::sort(found.begin(), found.end(), before);
  check(name + "none comes twice", std::adjacent_find(found.begin(), found.end()) == found.end());
  // At the region's rim, within the margin, particles that are known may come too.
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const Point<dim> &point) {
                               return std::find(cloud.position.begin(), cloud.position.end(), point) !=
                                      cloud.position.end();
                             }),
              found.end());
  std::sort(expected.begin(), expected.end(), before);
  check(name + "all of the balls' particles are found", found == expected);
  check(name + "there are such", Utilities::MPI::sum(expected.size(), MPI_COMM_WORLD) > 100);
  check(name + "a few at a time", n_rounds > 3);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  return n_failed > 0;
}
