// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_remeshing_cell_fluid_h
#define lahar_remeshing_cell_fluid_h

#include <lahar/particles/particle_cloud.h>

#include <functional>
#include <optional>

namespace Lahar
{
  /**
   * The number of the fluid that a cell of the given particles belongs to, by the sets of its fluid corners.
   *
   * - The fluid that all corners share, if it is the only one.
   * - If they share several, because all lie on an interface, the fluid that was there @p before; if there was none of
   *   these, the first of them.
   * - If they share none, as where two fluids meet, the fluid of the most corners; of several the one that was there
   *   before, else the first.
   *
   * @param before is asked only where the corners do not decide.
   */
  template <int dim>
  unsigned int fluid_of_cell(const std::array<unsigned int, dim + 1> &cell, const ParticleCloud<dim> &cloud,
                             const std::function<std::optional<unsigned int>()> &before);
} // namespace Lahar

#endif
