// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_held_vertices_h
#define lahar_simulator_held_vertices_h

#include <lahar/linear/node_constraint.h>
#include <lahar/linear/numbering.h>

#include <vector>

namespace Lahar
{
  /**
   * Fluid vertices that hit what lies behind a flat simplex.
   *
   * The vertex can follow a part of each increment only without flattening a simplex. Once the product of these parts,
   * over two or more iterations in a row, is below a fifth, the vertex is held: for the rest of the time step its
   * velocity is prescribed, as that of a wall is.
   */
  template <int dim>
  class HeldVertices
  {
  public:
    /// Begin a step, in which no vertex is held.
    void start_step(const IndexVector<LocalNode, bool> &can_be_held);

    /// Take note of an iteration. @param lengths the part of the increment that was taken.
    void note(const IndexVector<LocalNode, double> &lengths);

    /**
     * Hold vertices after an iteration: fix their velocities in @p constraints, by the numbers of @p partition.
     * @return whether there are new ones on any rank. Collective.
     * @throws RunError if more than one in a hundred are held.
     */
    bool update(const NodePartition &partition, IndexVector<LocalNode, NodeConstraint<dim>> &constraints);

    /// On all ranks together.
    unsigned int number() const
    {
      return n_held;
    }

  private:
    IndexVector<LocalNode, bool> can_be_held;
    IndexVector<LocalNode, double> followed;      ///< part of the last increment
    IndexVector<LocalNode, unsigned int> n_short; ///< iterations in a row with less than the whole increment
    IndexVector<LocalNode, double> product;       ///< of these iterations' parts
    unsigned int n_held = 0;
  };
} // namespace Lahar

#endif
