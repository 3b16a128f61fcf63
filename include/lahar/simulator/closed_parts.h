// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_closed_parts_h
#define lahar_simulator_closed_parts_h

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/linear/node_constraint.h>
#include <lahar/linear/node_partition.h>

#include <vector>

namespace Lahar
{
  /**
   * The connected parts of the fluid that have no free surface and no elastic solid at them: a pressure that is the same
   * everywhere, ∫ ∇N_I at node I, works on no free component of the velocities. Nothing determines the level of their
   * pressure, and nothing gives way if what is prescribed changes their volume.
   *
   * Parts may extend over several ranks. Cells have the local numbers of the NodePartition.
   */
  template <int dim>
  class ClosedParts
  {
  public:
    /**
     * Find the parts, and fix in @p constraints the pressure of one node of each: its level stays as it is. What fixes
     * whole parts must be in @p constraints already, see fix_undetermined_pressures(). Collective.
     * @param cells those that the rank knows, @p positions of their nodes.
     * @param is_compressible by node: whether a cell there gives way, so that its part is none of these.
     */
    void fix_levels(const std::vector<Simplex<dim>> &cells,
                    const IndexVector<LocalNode, Point<dim>> &positions, const NodePartition &partition,
                    const IndexVector<LocalNode, bool> &is_compressible,
                    IndexVector<LocalNode, NodeConstraint<dim>> &constraints);

    /**
     * @throws RunError if a part has other volumes at the end of the step than at its start, with a place in it.
     * Collective. Cells and positions as above, @p old_volumes and @p new_volumes of the cells.
     */
    void check(const std::vector<Simplex<dim>> &cells, const IndexVector<LocalNode, Point<dim>> &positions,
               const std::vector<double> &old_volumes, const std::vector<double> &new_volumes,
               const NodePartition &partition) const;

  private:
    IndexVector<LocalNode, double>
      label;             ///< the largest global number in its part; −1 in parts that are not closed
    bool is_any = false; ///< on any rank
  };
} // namespace Lahar

#endif
