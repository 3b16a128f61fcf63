// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_safeguards_h
#define lahar_simulator_safeguards_h

#include <lahar/linear/block_system.h>
#include <lahar/material/materials.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/simulator/closed_parts.h>
#include <lahar/simulator/crushed_cells.h>
#include <lahar/simulator/fluid_step.h>
#include <lahar/simulator/held_vertices.h>
#include <lahar/simulator/step_state.h>

#include <vector>

namespace Lahar
{
  /**
   * What keeps the nonlinear iteration of a step going where the mesh or what is prescribed would stop it, apart from the
   * solution itself. StepProblem asks it at these points:
   *
   * - slow_down() at the start: velocities that are expected do not flatten simplices;
   * - fix_pressures() when velocities have been prescribed: nothing else determines these pressures (ClosedParts);
   * - advance() when increments are taken: they are halved where simplices would be flattened;
   * - end_iteration(): cells that a solid crushes are left out (CrushedCells), vertices that cannot follow are held
   *   (HeldVertices);
   * - check_closed_parts() at the end.
   *
   * Ranks that know a cell or a
   * node decide alike on it. All functions are collective but those that tell what the last ones found.
   */
  template <int dim>
  class Safeguards
  {
  public:
    /// What a step has; mesh, system and numbering must live until it ends.
    struct Start
    {
      const FluidMesh<dim> &mesh; ///< what this rank works on
      const BlockSystem<dim> &system;
      const Numbering &numbering;
      const Materials &materials;
      IndexVector<LocalNode, bool> is_solid;        ///< by node: whether it is a solid's
      IndexVector<LocalNode, bool> can_be_held;     ///< by node: whether it is a particle of the fluid
      IndexVector<LocalNode, Point<dim>> positions; ///< at the start of the step, m
    };

    void start_step(Start start);

    /// Fix in @p constraints the pressures that nothing determines.
    void fix_pressures(IndexVector<LocalNode, NodeConstraint<dim>> &constraints);

    /**
     * Move the fluid by mean @p velocities that no simplex is flattened by: the vertices of such ones move less, down to
     * not at all, or, where nodes push them that move whatever the fluid does, down to the velocity of these. Walls and
     * driven solids keep theirs, and may leave no room.
     */
    void slow_down(const IndexVector<LocalNode, NodeConstraint<dim>> &constraints, FluidStep<dim> &fluid,
                   IndexVector<LocalNode, Tensor<1, dim>> &velocities) const;

    /**
     * Move the fluid by @p length times the increments of @p state. Where simplices would invert or lose most of their
     * volume, the increments of their vertices are halved until none does: a flat simplex at an impact must not hold up
     * the rest of the fluid.
     * @return mean velocities of the nodes.
     */
    IndexVector<LocalNode, Tensor<1, dim>>
    advance(const StepState<dim> &state, const double length,
            const IndexVector<LocalNode, NodeConstraint<dim>> &constraints, FluidStep<dim> &fluid);

    /// End an iteration: leave cells of @p fluid out, and hold vertices in @p constraints. @return whether these are others
    /// now; pressures are fixed then. @throws RunError if too many are held.
    bool end_iteration(FluidStep<dim> &fluid, IndexVector<LocalNode, NodeConstraint<dim>> &constraints);

    /// @throws RunError if fluid without a free surface could not keep its volume, see ClosedParts.
    void check_closed_parts(const FluidStep<dim> &fluid) const;

    /// Whether the last advance() halved increments.
    bool was_damped() const
    {
      return damped;
    }

    /// Number of vertices that are held, of all ranks.
    unsigned int n_held() const
    {
      return held_vertices.number();
    }

  private:
    /// The cells that cannot keep themselves from being crushed, of those that the present state would flatten.
    std::vector<unsigned int>
    crushable_cells(const FluidStep<dim> &fluid, const std::vector<double> &volumes,
                    const IndexVector<LocalNode, NodeConstraint<dim>> &constraints) const;
    void find_compressible_nodes(const Materials &materials);
    const FluidMesh<dim> *mesh     = nullptr;
    const BlockSystem<dim> *system = nullptr;
    const Numbering *numbering     = nullptr;
    IndexVector<LocalNode, bool> is_solid;
    IndexVector<LocalNode, Point<dim>> start_positions;
    bool any_incompressible = false;
    IndexVector<LocalNode, bool> is_compressible; ///< whether it has a cell of a compressible fluid
    HeldVertices<dim> held_vertices;
    CrushedCells crushed_cells;
    ClosedParts<dim> closed_parts;
    bool damped = false;
  };
} // namespace Lahar

#endif
