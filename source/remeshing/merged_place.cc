// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/merged_place.h>

#include <cmath>

namespace Lahar
{
  bool find_merged_place(const std::array<Point<2>, 4> &chain, const double farthest, Point<2> &place)
  {
    const auto &[previous, a, b, next] = chain;
    const Tensor<1, 2> chord = next - previous, normal = cross_product_2d(chord);
    if (chord.norm() < farthest)
      return false;
    // Twice the areas of previous, a, next, of a, b, next, and of previous, middle, next.
    const Point<2> middle = a + 0.5 * (b - a);
    const double first = normal * (a - previous), second = -(cross_product_2d(b - a) * (next - a)),
                 present = normal * (middle - previous);
    // A shift of the middle by s times the normal adds s |normal|² to the latter.
    double s = (first + second - present) / normal.norm_square();
    if (Symmetry::is_rotational())
    {
      // Rings are as their area times the sum of the corners' radii: (present + s |n|²) (radii + s n_r) is to be that of
      // both. Of the two solutions the one that is zero where nothing is missing.
      const double ends = previous[0] + next[0], radii = ends + middle[0];
      const double square       = normal.norm_square() * normal[0],
                   linear       = normal.norm_square() * radii + present * normal[0],
                   rest         = present * radii - first * (ends + a[0]) - second * (a[0] + b[0] + next[0]);
      const double discriminant = linear * linear - 4. * square * rest;
      if (!(linear > 0. && discriminant >= 0.))
        return false;
      s = -2. * rest / (linear + std::sqrt(discriminant));
    }
    place = middle + s * normal;
    return (s * normal).norm() <= farthest;
  }
} // namespace Lahar
