// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_plain_region_h
#define lahar_tests_plain_region_h

#include <lahar/remeshing/remesher.h>

#include "../tests.h"

namespace Tests
{
  /// For particles without a body whose shape they fill: the region of the simplices that the plain rule accepts. @p walls
  /// must outlive it.
  template <int dim>
  typename Remesher<dim>::Region plain_region(const Walls<dim> &walls)
  {
    AlphaShape<dim> alpha_shape;
    parse(alpha_shape);
    return [alpha_shape, &walls](const Simplex<dim> &simplex, const ParticleCloud<dim> &cloud) {
      return alpha_shape.accepts_plain(simplex, cloud, walls);
    };
  }
} // namespace Tests

#endif
