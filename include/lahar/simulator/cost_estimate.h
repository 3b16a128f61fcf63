// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_cost_estimate_h
#define lahar_simulator_cost_estimate_h

#include <lahar/utilities/parameters.h>

#include <string>

namespace Lahar
{
  /**
   * What a run will take on one rank, for option --check: the number of steps is the run's time over 'Time step', the wall
   * time steps × cells × 4.5 nonlinear iterations × t, the memory 180 MiB + cells × m, with what doc/performance.md has
   * measured:
   *
   * | | t (µs) | m (kB) |
   * |---|---|---|
   * | triangles, direct solver | 7 | 12 |
   * | triangles, iterative solver | 6 | 6 |
   * | tetrahedra | 8 | 3 |
   *
   * It is an estimate: other machines, spreading fluid, stiff flows and repeated steps take more, fluid at rest less.
   *
   * @param n_cells of fluid and solids at the start.
   */
  std::string estimate_cost(const unsigned int dim, const double n_cells, const Parameters &prm);
} // namespace Lahar

#endif
