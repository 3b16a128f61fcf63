// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_particles_fluid_set_h
#define lahar_particles_fluid_set_h

namespace Lahar
{
  /// Some of the fluids of a case: bit n stands for fluid number n.
  using FluidSet = unsigned int;

  /// A case has no more fluids than this.
  constexpr unsigned int most_fluids = 30;

  /// The set of one fluid.
  inline FluidSet fluid_set(const unsigned int fluid)
  {
    return 1U << fluid;
  }

  /// Whether the set has more than one fluid, as that of a particle on an interface.
  inline bool has_several(const FluidSet fluids)
  {
    return (fluids & (fluids - 1U)) != 0U;
  }

  /// Whether neither set is empty and they share no fluid.
  inline bool are_apart(const FluidSet a, const FluidSet b)
  {
    return a != 0U && b != 0U && (a & b) == 0U;
  }

  /// The smallest number in the set; 0 of an empty one.
  inline unsigned int first_fluid(const FluidSet fluids)
  {
    unsigned int n = 0;
    while (n + 1 < most_fluids && (fluids >> n) != 0U && (fluids >> n & 1U) == 0U)
      ++n;
    return n;
  }
} // namespace Lahar

#endif
