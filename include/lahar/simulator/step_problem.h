// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_step_problem_h
#define lahar_simulator_step_problem_h

#include <deal.II/base/timer.h>

#include <deal.II/lac/vector.h>

#include <lahar/assembly/fluid_assembler.h>
#include <lahar/boundary/outlets.h>
#include <lahar/linear/linear_solver.h>
#include <lahar/linear/numbering.h>
#include <lahar/remeshing/migration.h>
#include <lahar/simulator/safeguards.h>
#include <lahar/simulator/sliding_friction.h>
#include <lahar/simulator/solid_step.h>
#include <lahar/simulator/time_integration.h>

#include <memory>
#include <tuple>
#include <utility>

namespace Lahar
{
  /**
   * The nonlinear problem of one time step: state, residual, linear system and update, of the fluid and the solids
   * together. The nonlinear schemes drive it:
   *
   *   start_step()                     the unknowns are numbered, velocities and pressures are those that are expected
   *   assemble()                       residual and Jacobian of the present state
   *   until the increments are small:
   *     solve()                        increments of velocities and pressures
   *     take_step(length)              as often as wanted, each time from the state in which the system was solved
   *     end_iteration()                what must not stop the next iteration is held, left out or slides
   *     assemble()
   *   accept()                         the end of the step goes to particles and solids
   *
   * A step that fails is left anywhere, with a RunError; the next start_step() needs nothing of it. What keeps the
   * iteration going where the mesh would stop it is apart from this, in Safeguards.
   *
   * The system's nodes are the vertices of the fluid's mesh and then the solids' nodes that are none of these
   * (SolidStep). They are shared out among the ranks (NodePartition); who is who says Numbering. A rank has the state of
   * the nodes that it knows, and of all nodes of the solids, whose meshes are small. All functions are collective but
   * those that tell what the last one found.
   */
  template <int dim>
  class StepProblem
  {
  public:
    using Linearization = typename FluidAssembler<dim>::Linearization;

    StepProblem(const MPI_Comm &communicator, TimerOutput &timer);

    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /// What a step starts from.
    struct Start
    {
      const FluidMesh<dim> &mesh;
      const ParticleCloud<dim> &cloud;
      const Solids<dim> &solids;
      const Migration<dim> &migration;
      Materials materials;
      Tensor<1, dim> gravity; ///< m/s²
      double time;            ///< s
      double time_step;       ///< s
      bool is_first;          ///< whether the step is a run's first one
      /// By vertex; the particles' velocities and accelerations obey them already, but for what boundaries that
      /// move prescribe.
      std::vector<NodeConstraint<dim>> constraints;
      /// By vertex: whether it is a corner of a cell that has just become fluid, see TimeIntegration.
      const std::vector<bool> &arrives;
      /// Where fluid slides along surfaces that resist.
      std::vector<SlidingContact<dim>> sliding;
      /// Where fluid slides along solids.
      std::vector<SolidTouch<dim>> touches;
      /// Of an exact yield stress, by cell, see ExactPlasticStress; empty where there are none yet.
      const std::vector<SymmetricTensor<2, dim>> &multipliers;
      /// By cell, see FluidStructure::of_cells().
      std::vector<double> structure;
      const Outlets<dim> &outlets;
    };

    /// Begin a step: velocities and pressures start from the old ones, prescribed velocities have their values at the end.
    void start_step(const Start &start);

    /// Assemble residual and Jacobian. @throws RunError if a simplex is inverted.
    void assemble(const Linearization &linearization);

    /**
     * Solve the system for the increments, @p in_two_steps or coupled, see LinearSolver; errors of their norms below
     * @p negligible do no harm.
     * @return linear iterations or sweeps.
     */
    unsigned int solve(const double negligible, const bool in_two_steps = false);

    /// Move from the state in which the system was solved by @p length times the increments, less where simplices would be
    /// flattened, see Safeguards. May be called again with another length.
    void take_step(const double length);

    /// End an iteration: what cannot follow its increments is held or left out, see Safeguards, and friction is what the
    /// velocities ask for, see SlidingFriction.
    void end_iteration();

    /// Whether the last iteration solved the step's own equations, see SlidingFriction::is_settled(). Collective.
    bool is_settled() const;

    /// Whether the stabilisation has a projection, which an exact yield stress needs, see FluidAssembler.
    bool projects_residual() const
    {
      return assembler.projects_residual();
    }

    /// Λ_k of an exact yield stress become those of the present velocities, see ExactPlasticStress. Then assemble.
    /// @return what that adds to work_along_increment(), W. Collective.
    double update_multipliers();

    /// Undo the last update_multipliers(). Then assemble.
    void take_multipliers_back();

    /// Those, by cell of the mesh of the start of the step, to which @p multipliers belongs; in cells that this rank does
    /// not work on they stay.
    void get_multipliers(std::vector<SymmetricTensor<2, dim>> &multipliers) const;

    /// How much the present velocities still differ from those of an exact yield stress, of all cells; the energy is at
    /// least that of `Standing velocity`. Collective.
    typename FluidAssembler<dim>::YieldGap yield_gap() const;

    /// Whether the fluid is so slow that it counts as standing, see `Standing velocity`.
    bool is_standing() const
    {
      return step_state.mean_speed() < standing_velocity;
    }

    /// Whether increments were halved in the last step.
    bool was_damped() const
    {
      return safeguards.was_damped();
    }

    /// @throws RunError if fluid without a free surface could not keep its volume, see ClosedParts.
    void check_closed_parts() const;

    /// Number of vertices that are held.
    unsigned int n_held() const
    {
      return safeguards.n_held();
    }

    /// How far the fastest particle of @p cloud moves in the step, over its spacing, and where it starts from, m.
    std::pair<double, Point<dim>> largest_movement(const ParticleCloud<dim> &cloud) const;

    /**
     * δv·R_v + δp·R_p of the last assembled residual, in W. For the increments of Newton's method and C = −Qᵀ it is
     * −δv·Kδv − δp·Hδp, negative; it grows along the increments and is zero at the best place on their line.
     */
    double work_along_increment() const
    {
      return -(solution * system.right_hand_side());
    }

    /// ‖δv‖/‖v‖ and ‖δp‖/‖p‖ of the last solution, whatever the length of the step.
    double velocity_increment() const
    {
      return step_state.velocity_increment();
    }

    double pressure_increment() const
    {
      return step_state.pressure_increment();
    }

    /// Where ‖δv‖/‖v‖ + |δp|/‖p‖ of the last solution is largest, m.
    Point<dim> place_of_largest_increment() const;

    /// Norm of the assembled momentum residual at free unknowns, N.
    double momentum_residual_norm() const
    {
      return system.right_hand_side().block(0).l2_norm();
    }

    /// Norm of the assembled residual of the mass equation, m³/s (m²/s in 2D).
    double mass_residual_norm() const
    {
      return system.right_hand_side().block(1).l2_norm();
    }

    /// Write the accepted state back to the mesh's particles, those of other ranks that this one knows too, and to the
    /// solids.
    void accept(ParticleCloud<dim> &cloud, Solids<dim> &solids);

    /// The cells of the region's mesh that the step has left out of the equations, see CrushedCells.
    std::vector<unsigned int> left_out_cells() const;

    /// Forces on the fluid, N.
    struct Reactions
    {
      /// Of walls, and of solids that share the vertex or are all that it touches; meaningful at prescribed components,
      /// shared nodes and contacts. Zero at vertices that this rank does not know.
      std::vector<Tensor<1, dim>> at_vertices;
      /// Of slick solids, by node of the solids; empty if no fluid touches such.
      std::vector<Tensor<1, dim>> of_slick_solids;
    };

    /// Collective.
    Reactions reactions() const;

    /// The rule, in the step that was started last.
    const TimeIntegration &time_integration() const
    {
      return integration;
    }

    const Materials &fluids() const
    {
      return materials;
    }

    const MPI_Comm &communicator() const
    {
      return system.partition().communicator();
    }

  private:
    /// Number the nodes. @return where those are that this rank knows.
    IndexVector<LocalNode, Point<dim>> reinit_system(const ParticleCloud<dim> &cloud,
                                                     const Migration<dim> &migration);
    NodeIdentities identify_nodes(const ParticleCloud<dim> &cloud, const Migration<dim> &migration,
                                  const IndexVector<RegionNode, Point<dim>> &positions) const;
    /// Prescribe what is told by vertex of the region's mesh, and what the solids prescribe.
    void set_constraints(const Start &start, const IndexVector<LocalNode, Point<dim>> &positions);
    /// Multipliers of the cells, and which cells belong to parts of the fluid that stand.
    void start_multipliers(const std::vector<SymmetricTensor<2, dim>> &multipliers);
    void start_iteration();
    /// @throws RunError that names the place of the simplex that is inverted most. Collective.
    [[noreturn]] void throw_inverted() const;
    /// The fluid has moved: the solids follow, and what lies between both.
    void move_solids(const IndexVector<LocalNode, Tensor<1, dim>> &velocities);
    /// Whether a cell counts on this rank, the one of its node with the smallest number.
    std::vector<bool> counted_cells() const;
    /// Friction follows velocities, pressures and reactions.
    void iterate_friction();
    /// Velocities and pressures of the known nodes; velocities of the solids' own nodes are zero in those of the fluid.
    IndexVector<LocalNode, Tensor<1, dim>> node_velocities() const;
    IndexVector<LocalNode, Tensor<1, dim>> fluid_velocities() const;
    IndexVector<LocalNode, double> fluid_pressures() const;
    /// Those of all solids' nodes from those of the known nodes.
    IndexVector<SolidNode, Tensor<1, dim>>
    of_solids(const IndexVector<LocalNode, Tensor<1, dim>> &values) const;
    /// Bring the values of other ranks' vertices, for one fluid after the other, up to date.
    void update_by_fluid(std::vector<Tensor<1, dim>> &values) const;
    /// Impose the velocities that are prescribed on those of the nodes.
    void impose(IndexVector<LocalNode, Tensor<1, dim>> &velocities) const;
    /// What counts as nothing in this step, see StepState.
    typename StepState<dim>::Floors floors(const ParticleCloud<dim> &cloud) const;
    void set_norms();

    TimerOutput &timer;
    FluidAssembler<dim> assembler;
    BlockSystem<dim> system;
    std::unique_ptr<LinearSolver<dim>> linear_solver;
    typename BlockSystem<dim>::Vector solution;

    const FluidMesh<dim> *region_mesh = nullptr; ///< of all particles in this rank's region
    const FluidMesh<dim> *mesh        = nullptr; ///< what this rank works on of it
    FluidMesh<dim> part;                         ///< this, on several ranks
    Materials materials;
    TimeIntegration integration;
    FluidStep<dim> fluid;
    SolidStep<dim> solid;
    Numbering numbering;
    /// The mesh, the solids and the contacts that the system was made for.
    std::tuple<unsigned int, IndexVector<SolidNode, RegionNode>, std::vector<unsigned int>> numbered =
      {numbers::invalid_unsigned_int, {}, {}};
    StepState<dim> step_state;
    std::vector<SymmetricTensor<2, dim>> old_multipliers; ///< before the last update_multipliers()
    IndexVector<LocalNode, NodeConstraint<dim>> constraints;
    Safeguards<dim> safeguards;
    SolidContact<dim> contact;
    SlidingFriction<dim> friction;
    double standing_velocity = 1e-7; ///< m/s
  };

} // namespace Lahar

#endif
