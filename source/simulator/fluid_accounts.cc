// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/postprocess/postprocessor.h>
#include <lahar/simulator/fluid_accounts.h>

#include <cmath>

namespace Lahar
{
  template <int dim>
  void FluidAccounts<dim>::begin(const std::vector<std::string> &fluid_names, const Volumes &volumes)
  {
    AssertDimension(fluid_names.size(), volumes.size());
    names = fluid_names;
    accounts.resize(volumes.size());
    for (unsigned int f = 0; f < accounts.size(); ++f)
      accounts[f].begin(volumes[f]);
  }



  template <int dim>
  void FluidAccounts<dim>::solved(const Volumes &volumes, const Volumes &inflow, const Volumes &left_out)
  {
    for (unsigned int f = 0; f < accounts.size(); ++f)
      accounts[f].solved(volumes[f], inflow[f], left_out[f]);
  }



  template <int dim>
  void FluidAccounts<dim>::remeshed(const Volumes &volumes)
  {
    double sum = 0., sum_of_sizes = 0.;
    for (unsigned int f = 0; f < accounts.size(); ++f)
    {
      const double change = volumes[f] - accounts[f].volume();
      sum += change;
      sum_of_sizes += std::abs(change);
      accounts[f].remeshed(volumes[f]);
    }
    exchanged += 0.5 * (sum_of_sizes - std::abs(sum));
  }



  template <int dim>
  void FluidAccounts<dim>::corrected(const Volumes &volumes)
  {
    for (unsigned int f = 0; f < accounts.size(); ++f)
      accounts[f].remeshed(volumes[f]);
  }



  template <int dim>
  typename FluidAccounts<dim>::Volumes FluidAccounts<dim>::excess() const
  {
    Volumes result;
    double change = 0., volume = 0.;
    for (const VolumeAccount<dim> &account : accounts)
    {
      result.push_back(account.absolute_change());
      change += account.absolute_change();
      volume += account.volume();
    }
    for (unsigned int f = 0; f < accounts.size(); ++f)
      result[f] -= change * accounts[f].volume() / volume;
    return result;
  }



  template <int dim>
  void FluidAccounts<dim>::went_out(const Volumes &volumes)
  {
    for (unsigned int f = 0; f < accounts.size(); ++f)
      accounts[f].went_out(volumes[f]);
  }



  template <int dim>
  void FluidAccounts<dim>::left(const Volumes &volumes)
  {
    for (unsigned int f = 0; f < accounts.size(); ++f)
      accounts[f].left(volumes[f]);
  }



  template <int dim>
  void FluidAccounts<dim>::add_columns(TableHandler &statistics) const
  {
    double all = 0.;
    for (unsigned int f = 0; f < accounts.size(); ++f)
    {
      add_to_column(statistics, names[f] + " volume (m^dim)", accounts[f].volume());
      add_to_column(statistics, names[f] + " volume change by solver", accounts[f].change_by_solver());
      add_to_column(statistics, names[f] + " volume change by remeshing", accounts[f].change_by_remeshing());
      all += accounts[f].initial_volume();
    }
    if (!accounts.empty())
      add_to_column(statistics, "Volume exchanged between fluids", exchanged / all);
  }



  template class FluidAccounts<2>;
  template class FluidAccounts<3>;
} // namespace Lahar
