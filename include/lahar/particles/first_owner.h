// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_particles_first_owner_h
#define lahar_particles_first_owner_h

#include <cstdint>

namespace Lahar
{
  /// The rank of @p n_ranks that particle @p number of @p n belongs to before the work is known: equal parts in order.
  inline unsigned int first_owner(const std::uint64_t number, const std::uint64_t n,
                                  const unsigned int n_ranks)
  {
    return number * n_ranks / n;
  }
} // namespace Lahar

#endif
