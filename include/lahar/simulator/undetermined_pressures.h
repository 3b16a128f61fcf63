// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_undetermined_pressures_h
#define lahar_simulator_undetermined_pressures_h

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/linear/block_system.h>

#include <vector>

namespace Lahar
{
  /**
   * Where all velocities of a connected part of the fluid are prescribed, nothing determines the level of its pressure:
   * fix its pressures in @p constraints, and only these. Parts may extend over several ranks. Collective.
   * @param cells by the local numbers of @p partition.
   */
  template <int dim>
  void fix_undetermined_pressures(const std::vector<Simplex<dim>> &cells, const NodePartition &partition,
                                  IndexVector<LocalNode, NodeConstraint<dim>> &constraints);
} // namespace Lahar

#endif
