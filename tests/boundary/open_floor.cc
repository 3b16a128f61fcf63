// SPDX-License-Identifier: GPL-3.0-or-later

// Test the warning of fluid that nothing lies below: none above edges and corners of triangles of the ground, where a line
// downwards may miss both sides by rounding; one beside the ground, with number and place.

#include <lahar/boundary/open_floor.h>

#include "tests.h"

using namespace Tests;

constexpr unsigned int n_lines = 25;

double height(const double x, const double y)
{
  return 400. + 0.37 * x + 7. * std::sin(x / 31.) * std::cos(y / 17.);
}

/// A hill over the lines x, y = 500 + 10/3 k, each rectangle halved along its diagonal.
Walls<3> ground()
{
  const auto corner = [](const unsigned int i, const unsigned int j) {
    const double x = 500. + 10. * i / 3., y = 500. + 10. * j / 3.;
    return Point<3>(x, y, height(x, y));
  };
  std::vector<WallFacet<3>> facets;
  for (unsigned int i = 0; i + 1 < n_lines; ++i)
    for (unsigned int j = 0; j + 1 < n_lines; ++j)
    {
      facets.push_back({{{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)}}, true, 0, false, false});
      facets.push_back({{{corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)}}, true, 0, false, false});
    }
  return Walls<3>(facets);
}

int main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Walls<3> walls = ground();
  const Tensor<1, 3> gravity({0., 0., -9.81});
  ParticleCloud<3> cloud;
  Random random;
  const auto add = [&](const double x, const double y) {
    cloud.append(Point<3>(x, y, height(x, y) + 8. + random.number()), ParticleKind::fluid, 2.);
  };
  for (unsigned int i = 1; i + 1 < n_lines; ++i)
    for (unsigned int j = 1; j + 1 < n_lines; ++j)
    {
      const double x = 500. + 10. * i / 3., y = 500. + 10. * j / 3., along = 1.6 * random.number();
      add(x, y);
      add(x + along, y + along);
      add(x, y + along);
      add(x + along, y);
    }
  const std::string text = warn_of_open_floor(cloud, walls, gravity, MPI_COMM_WORLD);
  check("no warning above edges and corners", text.empty());
  if (!text.empty())
    std::cout << "    " << text << std::endl;

  add(400., 540.);
  const std::string beside = warn_of_open_floor(cloud, walls, gravity, MPI_COMM_WORLD);
  check("a warning beside the ground",
        beside.find("below 1 of") != std::string::npos && beside.find("(400 540 ") != std::string::npos);
  return n_failed > 0;
}
