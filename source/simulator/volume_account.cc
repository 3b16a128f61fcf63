// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/postprocessor.h>
#include <lahar/simulator/volume_account.h>
#include <lahar/utilities/ranks.h>

#include <cmath>
#include <sstream>
#include <tuple>

namespace Lahar
{
  namespace
  {
    /// The account of the volume is a matter for a warning beyond this part of the volume at the start.
    constexpr double largest_quiet_change = 0.01;
  } // namespace



  template <int dim>
  void VolumeAccount<dim>::add_columns(TableHandler &statistics) const
  {
    add_to_column(statistics, "Fluid volume (m^dim)", present);
    add_to_column(statistics, "Volume change by solver", by_solver / reference());
    add_to_column(statistics, "Volume change by remeshing", by_remeshing / reference());
  }



  template <int dim>
  void VolumeAccount<dim>::add_inflow_column(TableHandler &statistics) const
  {
    add_to_column(statistics, "Inflow volume (m^dim)", came_in);
  }



  template <int dim>
  void VolumeAccount<dim>::add_outflow_column(TableHandler &statistics) const
  {
    add_to_column(statistics, "Outflow volume (m^dim)", gone_out);
  }



  template <int dim>
  void VolumeAccount<dim>::add_left_column(TableHandler &statistics) const
  {
    add_to_column(statistics, "Volume left the domain", left_domain / reference());
  }



  template <int dim>
  std::string VolumeAccount<dim>::news(const ParticleCloud<dim> &cloud, const double time,
                                       const MPI_Comm &communicator)
  {
    if (has_warned || std::abs(change()) < largest_quiet_change)
      return "";
    has_warned = true;
    // Where the surface owes or is owed most of what remeshing could not take back.
    double largest = 0.;
    Point<dim> place;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.is_own(i) && std::abs(cloud.owed_volume[i]) > largest)
      {
        largest = std::abs(cloud.owed_volume[i]);
        place   = cloud.position[i];
      }
    std::tie(largest, place) = largest_of_all(largest, place, communicator);
    std::ostringstream text;
    text << "Warning: time " << time << " s: the fluid's volume has changed by " << 100. * change()
         << " %, of which the solver " << 100. * by_solver / reference() << " % and remeshing "
         << 100. * by_remeshing / reference() << " %";
    if (largest > 0.)
      text << ", most of it around (" << place << ") m";
    text << ". A smaller 'Mesh size' resolves what splashes and merges.";
    return text.str();
  }



  template class VolumeAccount<2>;
  template class VolumeAccount<3>;
} // namespace Lahar
