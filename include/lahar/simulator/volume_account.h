// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_volume_account_h
#define lahar_simulator_volume_account_h

#include <deal.II/base/table_handler.h>

#include <lahar/particles/particle_cloud.h>

#include <string>

namespace Lahar
{
  /**
   * The volume of the fluid, m^dim, and what has changed it, relative to the volume at the start: the solver, remeshing,
   * and fluid that has left the domain. Each function takes the volume of all ranks at present.
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

    /// After the particles of a step have moved with the mesh.
    void solved(const double volume)
    {
      by_solver += change_to(volume);
    }

    /// After a new mesh.
    void remeshed(const double volume)
    {
      by_remeshing += change_to(volume);
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

    /// By solver and remeshing.
    double change() const
    {
      return by_solver + by_remeshing;
    }

    /// Columns 'Fluid volume (m^dim)', 'Volume change by solver' and 'Volume change by remeshing'.
    void add_columns(TableHandler &statistics) const;

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
      archive &initial &present &by_solver &by_remeshing &left_domain &has_warned;
    }

  private:
    double change_to(const double volume)
    {
      const double change = (volume - present) / initial;
      present             = volume;
      return change;
    }

    double initial = 0., present = 0., by_solver = 0., by_remeshing = 0., left_domain = 0.;
    bool has_warned = false;
  };
} // namespace Lahar

#endif
