// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_momentum_account_h
#define lahar_simulator_momentum_account_h

#include <lahar/postprocess/postprocessor.h>

namespace Lahar
{
  /**
   * The momentum of the fluid in the mesh, N s (N s/m in 2D), and what changes it without a force: the changes of volume
   * that the solver leaves to cells, new cells, particles that are inserted, removed or stopped at walls and solids, fluid
   * that comes in or goes out. Fluid that leaves the domain takes its own with it.
   *
   *   P = ∫ ρ u,   u = v − (γ − 1) Δt a,
   *
   * linear in each cell, with γ, Δt and a of the TimeIntegration: u is what the mean forces F̄ change, Δu = Δt a, in steps
   * of the same length. With γ = 3/2 it is the mean velocity w of the step. So, with F̄ of all walls and solids,
   *
   *   P(N) − P(0) = Σ (∫ ρ g − F̄) Δt + change by solver + change by remeshing + inflow − outflow + change by lag.
   *
   * All changes but the last one are those of
   *
   *   E = P̂ + t R,   P̂ = ∫ ρ û,   û = u + t a,   t = −α Δt,
   *
   * R the sum of F̄ over the particles at walls and solids. P̂ is what the forces F at the ends of the steps change, Δû = Δt
   * dv/dt, for nodes that move impulsively, too: P̂_{n+1} − P̂_n = Δt (∫ ρ g − F) + ∫ ρ û_n over the change of the cells'
   * volumes, the change by solver. Σ F̄ Δt lags behind Σ F Δt by t R, so that R, which changes with the particles that are
   * at walls, counts as well.
   *
   * P, of the middle of a step for γ = 3/2, is not of the time to which the sum goes. The change by lag is P − E and what E
   * changes by where a step has another length than the one before. In flow whose forces change slowly it hardly changes
   * from the second step on, in which it becomes half of what the forces give in the first one; where an impact stops fluid
   * within a step it is the impulse that F̄ still owes.
   */
  template <int dim>
  class MomentumAccount
  {
  public:
    struct Momenta
    {
      Tensor<1, dim> mean; ///< P
      Tensor<1, dim> end;  ///< E
    };

    /// Whether u and û have another meaning with this (γ − 1) Δt, and with t less that, Δt/2 by Newmark's rule, s.
    bool has_other_times(const double new_carried_time, const double new_half_step) const
    {
      return new_carried_time != carried_time || new_half_step != half_step;
    }

    /// A step ends by which u and û have that meaning until the next one.
    void set_times(const double new_carried_time, const double new_half_step)
    {
      carried_time = new_carried_time;
      half_step    = new_half_step;
    }

    /// By another meaning of u and û the momenta have gone from @p before to @p after.
    void changed_times(const Momenta &before, const Momenta &after)
    {
      change_by_times += after.end - before.end;
    }

    /// The solver has changed the cells' volumes, and with them P̂ of the velocities before the step, by this.
    void solved(const Tensor<1, dim> &change)
    {
      change_by_solver += change;
    }

    /// Forces have led to @p value, or fluid has left.
    void set(const Momenta &value)
    {
      momentum = value.mean;
      end      = value.end;
    }

    /// Remeshing or a stop has.
    void changed(const Momenta &value)
    {
      change_by_remeshing += value.end - end;
      set(value);
    }

    /// Fluid has come in, or the particles that do have been renewed.
    void came_in(const Momenta &value)
    {
      inflow += value.end - end;
      set(value);
    }

    /// Fluid has gone out.
    void went_out(const Momenta &value)
    {
      outflow -= value.end - end;
      set(value);
    }

    /// û by particle.
    std::vector<Tensor<1, dim>> velocities(const ParticleCloud<dim> &cloud) const;

    /// Of all ranks at present. Collective.
    Momenta compute(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud, const Materials &materials,
                    const MPI_Comm &communicator) const;

    /// ∫ ρ u of all ranks where the particles are at present, @p u by particle. Collective.
    static Tensor<1, dim> integrate(const std::vector<Tensor<1, dim>> &u, const FluidMesh<dim> &mesh,
                                    const ParticleCloud<dim> &cloud, const Materials &materials,
                                    const MPI_Comm &communicator);

    /// Columns 'Momentum x (N s)' …, 'Momentum change by solver x (N s)' …, 'Momentum change by remeshing x (N s)' … and
    /// 'Momentum change by lag x (N s)' ….
    void add_columns(TableHandler &statistics) const;

    /// Columns 'Momentum inflow x (N s)' ….
    void add_inflow_columns(TableHandler &statistics) const;

    /// Columns 'Momentum outflow x (N s)' ….
    void add_outflow_columns(TableHandler &statistics) const;

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &carried_time &half_step &momentum &end &change_by_solver &change_by_remeshing &change_by_times
        &inflow &outflow;
    }

  private:
    double carried_time = 0.;     ///< (γ − 1) Δt of the last step, s
    double half_step    = 0.;     ///< û = v + half_step a, s
    Tensor<1, dim> momentum, end; ///< Momenta
    Tensor<1, dim> change_by_solver, change_by_remeshing, change_by_times, inflow, outflow;
  };
} // namespace Lahar

#endif
