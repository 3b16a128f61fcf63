// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_simulator_h
#define lahar_simulator_simulator_h

#include <deal.II/base/timer.h>

#include <lahar/boundary/slip_condition.h>
#include <lahar/boundary/solid_contour.h>
#include <lahar/boundary/walls.h>
#include <lahar/geometry/initial_geometry.h>
#include <lahar/geometry/mesh_size.h>
#include <lahar/material/fluid_law.h>
#include <lahar/particles/particle_cloud.h>
#include <lahar/postprocess/postprocessor.h>
#include <lahar/postprocess/progress.h>
#include <lahar/postprocess/visualization.h>
#include <lahar/remeshing/domain_limit.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/simulator/momentum_account.h>
#include <lahar/simulator/nonlinear_scheme.h>
#include <lahar/simulator/run_parameters.h>
#include <lahar/simulator/step_control.h>
#include <lahar/simulator/step_problem.h>
#include <lahar/simulator/time_integration.h>
#include <lahar/solid/solids.h>
#include <lahar/utilities/appended_file.h>
#include <lahar/utilities/checkpoint_file.h>
#include <lahar/utilities/output_directory.h>

#include <cstdint>
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
    /// @param n_solids for how many solids there are entries.
    static void declare_parameters(Parameters &prm, const unsigned int n_solids);

    /// Read all parameters. @throws InputError for anything that cannot be computed.
    Simulator(Parameters &prm, const MPI_Comm &communicator);

    /// Take the output directory for this run, see OutputDirectory::take(). Whoever does without it, as programs that
    /// use the library may, overwrites what is there. Collective. @throws InputError
    void take_output_directory(const OutputDirectory::Use use);

    /// Create particles, walls and first mesh. @throws InputError
    void initialize();

    /// After initialize(), go on from the checkpoint in the output directory. @throws InputError if there is none that
    /// can be read, or if a parameter, or what a mesh file holds, differs from the checkpoint's where a resumed run
    /// cannot honour it.
    void resume();

    /// What initialize() or resume() made, in a few lines. Collective.
    std::string sizes() const;

    /// Compute to the end time, or until a signal of StopSignal comes. Leaves a checkpoint. @throws RunError, whose reason
    /// stands in `log`, too.
    void run();

    /// What this rank knows of the particles.
    const ParticleCloud<dim> &cloud() const
    {
      return particles;
    }

    const FluidMesh<dim> &mesh() const
    {
      return fluid_mesh;
    }

  private:
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
    /// Bring particles and mesh to where they belong.
    void migrate();
    /// Sums over the ranks.
    double sum_of_ranks(const double value) const;
    unsigned int count_on_ranks(const unsigned int n) const;
    /// Of the cells, and what isolated particles carry, on all ranks.
    double fluid_volume() const;
    /// See MomentumAccount.
    Tensor<1, dim> fluid_momentum() const;
    void remesh(const double time_step);
    /// Largest ratio of speed and spacing in the mesh, 1/s.
    double fastest_movement() const;
    /// @throws RunError if a particle moves too far in the solved step.
    void check_movements() const;
    void move_particles(const double time_step);
    /// Forces of walls and solids on the fluid, see TimeIntegration::mean_force().
    void take_mean_forces();
    /// @throws RunError if a solid, whose nodes came from @p old_position, has run into something.
    void stop_at_collision(const std::vector<Point<dim>> &old_position);
    /// The rigid walls and the solids' contours.
    Walls<dim> obstacles(const SolidContour<dim> &contour) const;
    std::vector<NodeConstraint<dim>> constraints() const;
    /// Make the first mesh and adapt the particles to it, until nothing changes.
    void create_first_mesh();
    void set_initial_velocities();
    /// Where the first mesh does not show the shapes that were asked for.
    void warn_of_coarse_mesh();
    void add_statistics(const double time_step, const NonlinearReport &report);
    /// Say once when the account of the volume has passed one percent.
    void warn_of_volume();
    Snapshot<dim> snapshot();

    /// run() without what concerns its failures.
    void compute();
    void start_output();
    /// Make again what others have removed of the output, and say so. Collective. @throws RunError where that cannot be.
    void mend_output();
    void write_parameters() const;
    void advance_output_time();
    void write_snapshot();
    bool checkpoint_is_due() const;
    /// Note down all that a checkpoint of this moment holds.
    void keep_state();
    /// Write what was noted down last.
    void write_kept_state();
    void write_checkpoint();
    template <typename Archive>
    void save_or_load(Archive &archive);
    /// What is common to all ranks. Collective, though the first rank's counts.
    std::string save_state();
    std::string save_piece() const;
    /// @param divide whether there are as many pieces as ranks, which therefore share space as before.
    void load_pieces(const std::vector<std::string> &pieces, const bool divide);
    void check_unchanged(const std::map<std::string, std::string> &earlier_values) const;
    /// Checksums of the files that entries name, by entry.
    std::map<std::string, unsigned int> file_checksums() const;
    void check_files(const std::map<std::string, unsigned int> &earlier_files) const;
    /// Own particles and cells on all ranks.
    std::pair<unsigned int, unsigned int> particles_and_cells() const;

    MPI_Comm communicator;
    Parameters &prm;
    RunParameters parameters;

    std::unique_ptr<FluidLaw> law;
    Tensor<1, dim> gravity;
    MeshSize<dim> mesh_size;
    InitialGeometry<dim> geometry;
    std::string initial_velocity;
    TimeIntegration time_integration;
    DomainLimit<dim> domain_limit;
    Remesher<dim> remesher;
    Migration<dim> migration;
    std::unique_ptr<NonlinearScheme<dim>> scheme;
    std::unique_ptr<StepControl> step_control;

    Solids<dim> solids;
    ParticleCloud<dim> particles;
    Walls<dim> walls;
    SlipCondition<dim> slip_condition;
    FluidMesh<dim> fluid_mesh;

    TimerOutput timer;
    StepProblem<dim> problem;

    double time              = 0.;
    unsigned int step_number = 0, n_rejected = 0, n_forced_facets = 0, n_kept_out = 0, n_left = 0,
                 n_cells  = 0; ///< of the fluid, on all ranks
    double initial_volume = 0., volume = 0., change_by_solver = 0., change_by_remeshing = 0.,
           left_volume = 0.;
    MomentumAccount<dim> momentum;
    TimeMeans means;                          ///< since the last snapshot
    typename Remesher<dim>::Report remeshing; ///< the last one

    std::vector<std::string> warnings;
    bool warned_of_volume = false;
    std::vector<std::unique_ptr<Postprocessor<dim>>> postprocessors;
    AppendedFile statistics;
    AppendedFile convergence; ///< the increments of every iteration
    typename OutputField<dim>::List fields;
    std::unique_ptr<Visualization<dim>> visualization;
    std::unique_ptr<Progress> progress;
    double last_output_time = 0.; ///< when output was due last, s

    OutputDirectory directory;
    CheckpointFile checkpoint;
    CheckpointFile::Piece piece;               ///< this rank's of the last checkpoint
    std::map<std::string, unsigned int> files; ///< file_checksums() as the run began
    bool resumed                     = false;
    double last_checkpoint_wall_time = 0., earlier_wall_time = 0.; ///< s
    double checkpoint_duration = 0.;                               ///< of the last one, s
    struct
    {
      std::string piece, state;                               ///< the state on the first rank only
    } kept;                                                   ///< by keep_state()
    std::map<std::string, std::string> parameter_values;      ///< on the first rank, once they are needed
    std::uintmax_t statistics_size = 0, convergence_size = 0; ///< of the files at the checkpoint, bytes
  };
} // namespace Lahar

#endif
