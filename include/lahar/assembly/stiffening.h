// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_stiffening_h
#define lahar_assembly_stiffening_h

namespace Lahar
{
  // Along d' the primal-dual Jacobian of a yielding cell almost vanishes. Where Λ and the strain rate do not agree yet, so
  // that this says little about the solution, part of the secant stiffness is left in it: in the cell, since a thread of a
  // few cells that yields in tension cannot be seen in any norm over all cells. With a mismatch of e (1 = of the size of Λ)
  // the part is min(#largest_stiffening, #stiffening_rate e).

  /// The largest part of the secant stiffness that is left.
  constexpr double largest_stiffening = 0.3;

  /// The part that is left, over the mismatch.
  constexpr double stiffening_rate = 3.;
} // namespace Lahar

#endif
