// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_rate_powers_h
#define lahar_material_rate_powers_h

namespace Lahar
{
  // Bounds of laws with powers of the strain rate.

  /// Strain rate (1/s) below which the fluid is at rest: powers of it stay finite.
  constexpr double no_rate = 1e-100;

  /// Exponents of transitions between two viscosities that are allowed.
  constexpr double smallest_exponent = 0.1, largest_exponent = 10.;
} // namespace Lahar

#endif
