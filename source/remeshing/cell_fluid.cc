// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/cell_fluid.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  unsigned int fluid_of_cell(const std::array<unsigned int, dim + 1> &cell, const ParticleCloud<dim> &cloud,
                             const std::function<std::optional<unsigned int>()> &before)
  {
    FluidSet shared = ~0U, any = 0U;
    for (const unsigned int i : cell)
      if (cloud.kind[i] == ParticleKind::fluid)
      {
        shared &= cloud.part[i];
        any |= cloud.part[i];
      }
    if (!has_several(any))
      return first_fluid(any);

    FluidSet possible = shared;
    if (possible == 0U)
    {
      unsigned int most = 0;
      for (unsigned int fluid = 0; fluid < most_fluids; ++fluid)
      {
        const unsigned int n = std::count_if(cell.begin(), cell.end(), [&](const unsigned int i) {
          return cloud.kind[i] == ParticleKind::fluid && (cloud.part[i] & fluid_set(fluid)) != 0U;
        });
        if (n > most)
          possible = 0U;
        most = std::max(most, n);
        if (n > 0 && n == most)
          possible |= fluid_set(fluid);
      }
    }
    if (has_several(possible))
      if (const auto fluid = before(); fluid && (possible & fluid_set(*fluid)) != 0U)
        return *fluid;
    return first_fluid(possible);
  }



  template unsigned int fluid_of_cell<2>(const std::array<unsigned int, 3> &, const ParticleCloud<2> &,
                                         const std::function<std::optional<unsigned int>()> &);
  template unsigned int fluid_of_cell<3>(const std::array<unsigned int, 4> &, const ParticleCloud<3> &,
                                         const std::function<std::optional<unsigned int>()> &);
} // namespace Lahar
