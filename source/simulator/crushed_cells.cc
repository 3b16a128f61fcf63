// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/simulator/crushed_cells.h>

namespace Lahar
{
  namespace
  {
    constexpr unsigned int n_times_to_leave_out = 5;
  }



  void CrushedCells::start_step(const unsigned int n_cells)
  {
    n_times.assign(n_cells, 0);
  }



  void CrushedCells::note(const std::vector<unsigned int> &cells)
  {
    for (const unsigned int c : cells)
      ++n_times[c];
  }



  void CrushedCells::update(std::vector<bool> &left_out) const
  {
    for (unsigned int c = 0; c < n_times.size(); ++c)
      if (n_times[c] >= n_times_to_leave_out)
        left_out[c] = true;
  }
} // namespace Lahar
