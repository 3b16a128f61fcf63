// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_simulator_h
#define lahar_simulator_simulator_h

#include <deal.II/base/timer.h>

#include <lahar/boundary/inlets.h>
#include <lahar/boundary/outlets.h>
#include <lahar/boundary/solid_contour.h>
#include <lahar/geometry/walls.h>
#include <lahar/remeshing/migration.h>
#include <lahar/simulator/accounts.h>
#include <lahar/simulator/case.h>
#include <lahar/simulator/fluid_region.h>
#include <lahar/simulator/nonlinear_scheme.h>
#include <lahar/simulator/run_checkpoint.h>
#include <lahar/simulator/run_output.h>
#include <lahar/simulator/step_control.h>
#include <lahar/simulator/step_problem.h>
#include <lahar/solid/solids.h>

#include <map>
#include <memory>

namespace Lahar
{
  /**
   * Computes a case: creates the particles, makes time steps until the end time, writes the results.
   *
   * step() is one time step from beginning to end. On several ranks each has the particles and the fluid's mesh in its
   * region (Migration), and the solids, which are small, as a whole. The first rank writes all files but its and the
   * others' pieces of snapshots and checkpoints.
   */
  template <int dim>
  class Simulator
  {
  public:
    /// @param structure the parts for which there are entries.
    static void declare_parameters(Parameters &prm, const CaseStructure &structure);

    /// Read all parameters. @throws InputError for anything that cannot be computed.
    Simulator(Parameters &prm, const CaseStructure &structure, const MPI_Comm &communicator);

    /// Take the output directory for this run, see OutputDirectory::take(). Whoever does without it, as programs that
    /// use the library may, overwrites what is there. Collective. @throws InputError
    void take_output_directory(const OutputDirectory::Use use)
    {
      output.take_directory(use);
    }

    /// Create particles, walls and first mesh. @throws InputError
    void initialize();

    /// After initialize(), go on from the checkpoint in the output directory. @throws InputError if there is none that
    /// can be read, or if a parameter, or what a mesh file holds, differs from the checkpoint's where a resumed run
    /// cannot honour it.
    void resume();

    /// What initialize() or resume() made, in a few lines. Collective.
    std::string sizes() const;

    /// Write what initialize() made into the output directory, as RunOutput::write_start(). Collective.
    void write_start();

    /// Compute to the end time, or until a signal of StopSignal comes. Leaves a checkpoint. @throws RunError, whose reason
    /// stands in `log`, too.
    void run();

    /// What this rank knows of the particles.
    const ParticleCloud<dim> &cloud() const
    {
      return region.particles;
    }

    const FluidMesh<dim> &mesh() const
    {
      return region.mesh;
    }

  private:
    const MPI_Comm &communicator() const
    {
      return migration.communicator();
    }

    /**
     * One time step: remesh, solve, move, account. A step whose nonlinear iteration fails leaves the particles where
     * they were and is repeated with half the length. @throws StopRequest between nonlinear iterations after a signal;
     * what the step has changed until then is not in the state that was kept.
     */
    void step(double time_step);

    /// @throws RunError if the solids are not the same on all ranks.
    void check_ranks() const;
    /// See Remesher::region_distance().
    double region_distance() const;
    /// Bring particles and mesh to where they belong, or only the copies.
    void migrate(const bool keeps_owners = false);
    /// Sum over the ranks.
    unsigned int count_on_ranks(const unsigned int n) const;
    /// What the accounts look at.
    typename Accounts<dim>::Fluid fluid() const
    {
      return {region.mesh, region.particles, inlets, materials, communicator()};
    }
    /// Whether there is an exact yield stress, whose multipliers are carried along.
    bool has_multipliers() const
    {
      return materials.any_exact_yield_stress();
    }
    void remesh(const double time_step);
    /// Fluid goes out, fluid that has come in gets its cells.
    void exchange_fluid();
    /// Largest ratio of speed and spacing in the mesh, 1/s; inflow counts as if it moved farther than it may.
    double fastest_movement() const;
    /// @throws RunError if a particle moves too far in the solved step.
    void check_movements() const;
    /// @param wall_step the walls in the step that was solved.
    void move_particles(const double time_step, const WallStep<dim> &wall_step);
    /// Of the cells of the region's mesh that the solved step left out of the equations, m^dim.
    std::map<unsigned int, double> volumes_of_left_out() const;
    /// After a step that was solved: what the fluid carries along of its past, structure and multipliers.
    void advance_history(const double time_step);
    /// Forces of walls and solids on the fluid, see TimeIntegration::mean_force().
    void take_mean_forces(const std::vector<FacePressure<dim>> &pressures);
    /// @throws RunError if a solid, whose nodes came from @p old_position, has run into something.
    void stop_at_collision(const std::vector<Point<dim>> &old_position, const WallStep<dim> &wall_step);
    /// The rigid walls, and behind them the solids' contours, slick ones first.
    Walls<dim> obstacles(const SolidContour<dim> &contour) const;
    /// The facets of the slick contours as particles.
    std::vector<std::array<unsigned int, dim>> slick_facets() const;
    /// A step of the rigid walls with the slick contours behind them, whose particles came from @p old_position to where
    /// they are now.
    WallStep<dim> with_slick_solids(const WallStep<dim> &rigid, const std::vector<Point<dim>> &old_position,
                                    const double time_step) const;
    /// Those of the boundaries, and behind them those of the solids.
    std::vector<const SurfaceLaw *> surface_laws() const;
    /// What walls and inflow prescribe in a step, by vertex.
    std::vector<NodeConstraint<dim>> constraints(const WallStep<dim> &wall_step) const;
    /// Make the first mesh and adapt the particles to it, until nothing changes.
    void create_first_mesh();
    /// Say where the first mesh does not show the shapes that were asked for.
    void warn_of_coarse_mesh();
    void add_statistics(const double time_step, const NonlinearReport &report);
    Snapshot<dim> snapshot();

    /// run() without what concerns its failures.
    void compute();
    /// Begin or go on with the files of the output directory.
    void start_output();
    /// Write a checkpoint if one is due.
    void write_due_checkpoint();
    /// Note down all that a checkpoint of this moment holds.
    void keep_state();
    /// Write what was noted down last.
    void write_kept_state();
    void write_checkpoint();
    /// What is common to all ranks.
    template <typename Archive>
    void save_or_load(Archive &archive);
    /// The same as text, on the first rank. Collective.
    std::string save_state();
    std::string save_piece() const;
    void load_pieces(const RunCheckpoint::Content &content);

    Parameters &prm;
    Case<dim> input;
    Materials materials; ///< of its fluids
    Solids<dim> solids;
    Remesher<dim> remesher;
    Migration<dim> migration;
    std::unique_ptr<NonlinearScheme<dim>> scheme;
    std::unique_ptr<StepControl> step_control;
    TimerOutput timer;
    StepProblem<dim> problem;

    double time = 0.; ///< s
    FluidRegion<dim> region;
    Walls<dim> walls;
    Inlets<dim> inlets;
    Outlets<dim> outlets;

    Accounts<dim> account;
    RunOutput<dim> output;
    RunCheckpoint checkpoint;
  };
} // namespace Lahar

#endif
