// SPDX-License-Identifier: GPL-3.0-or-later

// Test that two merged particles of a surface enclose with their neighbours what the two did: the area in the plane, the
// volume of the ring with rotational symmetry, near the axis and far from it, on surfaces of all inclinations.

#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/merged_place.h>

#include "tests.h"

using namespace Tests;

/// Of the polygon of the points, with sign; a triangle's ring has it at its centroid.
double enclosed(const std::vector<Point<2>> &points)
{
  double sum = 0.;
  for (unsigned int k = 2; k < points.size(); ++k)
    sum += body_volume<2>({{points[0], points[k - 1], points[k]}});
  return sum;
}

void test(const bool rotational)
{
  Symmetry::set_rotational(rotational);
  const std::string name = rotational ? "rings: " : "plane: ";
  Random random;
  double error = 0., farthest = 0., beside = 0.;
  unsigned int n_found = 0;
  for (const double radius : {1.5, 3., 100.})
    for (double angle = 0.; angle < 6.28; angle += 0.1)
    {
      // A chain across which the fluid bulges or hollows, its edges about one long, the middle one short.
      const Tensor<1, 2> along({std::cos(angle), std::sin(angle)}), across({-along[1], along[0]});
      std::array<Point<2>, 4> chain;
      const double places[4] = {-1.2, -0.2, 0.2, 1.2};
      for (unsigned int k = 0; k < 4; ++k)
        chain[k] = Point<2>(radius, 0.) + places[k] * along + 0.3 * random.number() * across;
      Point<2> place;
      if (!find_merged_place(chain, 0.5, place))
        continue;
      ++n_found;
      const double before = enclosed({chain[0], chain[1], chain[2], chain[3]}),
                   after  = enclosed({chain[0], place, chain[3]});
      // Over a ring as large as the chain.
      const double size = rotational ? 2. * numbers::PI * radius : 1.;
      error             = std::max(error, std::abs(after - before) / size);
      farthest          = std::max(farthest, place.distance(chain[1] + 0.5 * (chain[2] - chain[1])));
      Point<2> in_plane;
      Symmetry::set_rotational(false);
      find_merged_place(chain, 0.5, in_plane);
      Symmetry::set_rotational(rotational);
      beside = std::max(beside, std::abs(enclosed({chain[0], in_plane, chain[3]}) - before) / size);
    }
  check(name + "there are places", n_found > 150);
  check(name + "what is enclosed stays", error, 1e-14);
  check(name + "the place is near the middle", farthest <= 0.5);
  check(name + "that of the plane encloses something else", (beside > 1e-3) == rotational);
  Symmetry::set_rotational(false);
}

int main()
{
  test(false);
  test(true);
  return n_failed;
}
