// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_momentum_account_h
#define lahar_simulator_momentum_account_h

#include <lahar/postprocess/postprocessor.h>

namespace Lahar
{
  /**
   * The momentum of the fluid in the mesh, N s (N s/m in 2D), and what changes it without a force: new cells, particles
   * that are inserted, removed or stopped at walls and solids, fluid that comes in or goes out. Fluid that leaves the
   * domain takes its own with it.
   *
   *   P = ∫ ρ u,   u = v − (γ − 1) Δt a,
   *
   * linear in each cell, with γ, Δt and a of the TimeIntegration: u is what the mean forces F̄ change, Δu = Δt a, in steps
   * of the same length. With γ = 3/2 it is the mean velocity w of the step. So, with F̄ of all walls and solids,
   *
   *   P(N) − P(0) = Σ (∫ ρ g − F̄) Δt + change by remeshing + inflow − outflow,
   *
   * where the first step, in which the acceleration is constant, counts half for γ = 3/2.
   */
  template <int dim>
  class MomentumAccount
  {
  public:
    /// A step begins, in which u has its meaning until the next one: @p new_carried_time is (γ − 1) Δt, s.
    void start_step(const double new_carried_time)
    {
      carried_time = new_carried_time;
    }

    /// Forces have led to @p value, or fluid has left.
    void set(const Tensor<1, dim> &value)
    {
      momentum = value;
    }

    /// Remeshing or a stop has.
    void changed(const Tensor<1, dim> &value)
    {
      change_by_remeshing += value - momentum;
      momentum = value;
    }

    /// Fluid has come in, or the particles that do have been renewed.
    void came_in(const Tensor<1, dim> &value)
    {
      inflow += value - momentum;
      momentum = value;
    }

    /// Fluid has gone out.
    void went_out(const Tensor<1, dim> &value)
    {
      outflow -= value - momentum;
      momentum = value;
    }

    /// P of all ranks at present. Collective.
    Tensor<1, dim> compute(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                           const Materials &materials, const MPI_Comm &communicator) const;

    /// Columns 'Momentum x (N s)' … and 'Momentum change by remeshing x (N s)' ….
    void add_columns(TableHandler &statistics) const;

    /// Columns 'Momentum inflow x (N s)' ….
    void add_inflow_columns(TableHandler &statistics) const;

    /// Columns 'Momentum outflow x (N s)' ….
    void add_outflow_columns(TableHandler &statistics) const;

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &carried_time &momentum &change_by_remeshing &inflow &outflow;
    }

  private:
    double carried_time = 0.; ///< (γ − 1) Δt of the last step, s
    Tensor<1, dim> momentum, change_by_remeshing, inflow, outflow;
  };
} // namespace Lahar

#endif
