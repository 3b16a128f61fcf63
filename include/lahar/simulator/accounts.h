// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_accounts_h
#define lahar_simulator_accounts_h

#include <lahar/boundary/inlets.h>
#include <lahar/simulator/fluid_accounts.h>
#include <lahar/simulator/ill_posed_cells.h>
#include <lahar/simulator/momentum_account.h>
#include <lahar/simulator/step_counters.h>
#include <lahar/simulator/volume_account.h>

namespace Lahar
{
  /**
   * What is counted and added up since the start of a run: the fluid's volume, that of each of several fluids and the
   * momentum, each by what has changed it; what happened how often. The functions are told of an event, and look at the
   * fluid as it is then; those with a Fluid are collective.
   */
  template <int dim>
  struct Accounts
  {
    /// The fluid as it is, on this rank.
    struct Fluid
    {
      const FluidMesh<dim> &mesh;
      const ParticleCloud<dim> &cloud;
      const Inlets<dim> &inlets;
      const Materials &materials;
      const MPI_Comm &communicator;
    };

    StepCounters counters;
    VolumeAccount<dim> volume;
    FluidAccounts<dim> fluids;
    MomentumAccount<dim> momentum;
    IllPosedCells<dim> ill_posed_cells;

    /// The run begins, with fluids of these names.
    void begin(const std::vector<std::string> &fluid_names, const Fluid &fluid);

    /// Of all ranks @p n particles behind outlets were dropped.
    void went_out(const unsigned int n, const Fluid &fluid);

    /// Fluid has come in.
    void came_in(const Fluid &fluid);

    /// Of all ranks @p n particles beyond the domain were dropped.
    void left(const unsigned int n, const Fluid &fluid);

    /// There is a new mesh; rearranged() follows.
    void remeshed(const Fluid &fluid);

    /// Interfaces have moved to give back what the new mesh exchanged between fluids.
    void corrected(const Fluid &fluid);

    /// The fluid at the end of a step, before its particles move.
    struct BeforeMove
    {
      std::vector<Tensor<1, dim>> velocities; ///< û of MomentumAccount, by particle
      Tensor<1, dim> momentum;                ///< of these
    };

    /// A step ends whose accelerations carry momentum for @p carried_time and whose mean forces lag behind by @p lag (s),
    /// see MomentumAccount.
    BeforeMove end_step(const double carried_time, const double lag, const Fluid &fluid);

    /// The particles have moved as the step says. @param left_out by how much this rank's own cells that were left out of the
    /// equations have grown, by fluid, m^dim.
    void solved(const BeforeMove &before, const std::vector<double> &left_out, const Fluid &fluid);

    /// What has moved or come and gone since the last event did so without a force.
    void rearranged(const Fluid &fluid);

    /// What is common to all ranks; each one's ill_posed_cells are not.
    template <typename Archive>
    void save_or_load(Archive &archive)
    {
      archive &counters &volume &fluids &momentum;
    }

  private:
    /// Of the cells, what isolated particles carry, and what comes in at present, on all ranks.
    static double volume_of(const Fluid &fluid);
    /// The same of each fluid, where there are several.
    static std::vector<double> volumes_of(const Fluid &fluid);
    typename MomentumAccount<dim>::Momenta momentum_of(const Fluid &fluid) const;
    /// Of given velocities, by particle.
    static Tensor<1, dim> momentum_of(const std::vector<Tensor<1, dim>> &velocities, const Fluid &fluid);
  };
} // namespace Lahar

#endif
