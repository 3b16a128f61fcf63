// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_volume_account_h
#define lahar_simulator_volume_account_h

#include <deal.II/base/table_handler.h>

#include <lahar/particles/particle_cloud.h>

#include <string>

namespace Lahar
{
  /**
   * The volume of the fluid, m^dim, and what has changed it: the solver, remeshing, fluid that has come in or gone out
   * through a boundary, or left the domain. All but the fourth and the fifth are told relative to the volume that has been
   * in the case, at the start or since. Each function takes the volume of all ranks at present.
   */
  template <int dim>
  class VolumeAccount
  {
  public:
    /// At the start.
    void begin(const double volume)
    {
      initial = present = volume;
    }

    /// After the particles of a step, in which @p inflow came in, have moved with the mesh. Cells that were left out of the
    /// equations have grown by @p left_out: that counts with remeshing, which replaces them.
    void solved(const double volume, const double inflow, const double left_out)
    {
      by_solver += change_to(volume) - inflow - left_out;
      by_remeshing += left_out;
      came_in += inflow;
    }

    /// After a new mesh.
    void remeshed(const double volume)
    {
      by_remeshing += change_to(volume);
    }

    /// After particles behind an outlet were dropped.
    void went_out(const double volume)
    {
      gone_out -= change_to(volume);
    }

    /// After particles beyond the domain were dropped.
    void left(const double volume)
    {
      left_domain -= change_to(volume);
    }

    /// At the start, m^dim.
    double initial_volume() const
    {
      return initial;
    }

    /// At present, m^dim.
    double volume() const
    {
      return present;
    }

    /// By solver and remeshing, m^dim.
    double absolute_change() const
    {
      return by_solver + by_remeshing;
    }

    /// Relative.
    double change_by_solver() const
    {
      return by_solver / reference();
    }

    double change_by_remeshing() const
    {
      return by_remeshing / reference();
    }

    /// By solver and remeshing, relative.
    double change() const
    {
      return (by_solver + by_remeshing) / reference();
    }

    /// Columns 'Fluid volume (m^dim)', 'Volume change by solver' and 'Volume change by remeshing'.
    void add_columns(TableHandler &statistics) const;

    /// Column 'Inflow volume (m^dim)'.
    void add_inflow_column(TableHandler &statistics) const;

    /// Column 'Outflow volume (m^dim)'.
    void add_outflow_column(TableHandler &statistics) const;

    /// Column 'Volume left the domain'.
    void add_left_column(TableHandler &statistics) const;

    /**
     * A warning for people, once, when change() has passed one percent: how much, and where the surface owes or is owed
     * most (ParticleCloud::owed_volume). Empty otherwise. Collective. @param time s.
     */
    std::string news(const ParticleCloud<dim> &cloud, const double time, const MPI_Comm &communicator);

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &initial &present &by_solver &by_remeshing &came_in &gone_out &left_domain &has_warned;
    }

  private:
    double change_to(const double volume)
    {
      const double change = volume - present;
      present             = volume;
      return change;
    }

    /// What relative changes are relative to; without fluid, where all are zero, 1.
    double reference() const
    {
      return initial + came_in > 0. ? initial + came_in : 1.;
    }

    double initial = 0., present = 0., by_solver = 0., by_remeshing = 0., came_in = 0., gone_out = 0.,
           left_domain = 0.; ///< m^dim
    bool has_warned    = false;
  };
} // namespace Lahar

#endif
