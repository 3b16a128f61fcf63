// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/volume_correction.h>
#include <lahar/simulator/accounts.h>

#include <numeric>

namespace Lahar
{
  template <int dim>
  void Accounts<dim>::begin(const std::vector<std::string> &fluid_names, const Fluid &fluid)
  {
    volume.begin(volume_of(fluid));
    if (fluid.materials.n_fluids() > 1)
      fluids.begin(fluid_names, volumes_of(fluid));
    momentum.set(momentum_of(fluid));
  }



  template <int dim>
  void Accounts<dim>::went_out(const unsigned int n, const Fluid &fluid)
  {
    counters.gone_out += n;
    volume.went_out(volume_of(fluid));
    fluids.went_out(volumes_of(fluid));
    momentum.went_out(momentum_of(fluid));
  }



  template <int dim>
  void Accounts<dim>::came_in(const Fluid &fluid)
  {
    momentum.came_in(momentum_of(fluid));
  }



  template <int dim>
  void Accounts<dim>::left(const unsigned int n, const Fluid &fluid)
  {
    counters.left += n;
    volume.left(volume_of(fluid));
    fluids.left(volumes_of(fluid));
    momentum.set(momentum_of(fluid));
  }



  template <int dim>
  void Accounts<dim>::remeshed(const Fluid &fluid)
  {
    volume.remeshed(volume_of(fluid));
    fluids.remeshed(volumes_of(fluid));
  }



  template <int dim>
  void Accounts<dim>::corrected(const Fluid &fluid)
  {
    fluids.corrected(volumes_of(fluid));
  }



  template <int dim>
  typename Accounts<dim>::BeforeMove Accounts<dim>::end_step(const double carried_time, const double lag,
                                                             const Fluid &fluid)
  {
    if (momentum.has_other_times(carried_time, lag - carried_time))
    {
      const auto with_old_times = momentum_of(fluid);
      momentum.set_times(carried_time, lag - carried_time);
      momentum.changed_times(with_old_times, momentum_of(fluid));
    }
    BeforeMove before;
    before.velocities = momentum.velocities(fluid.cloud);
    before.momentum   = momentum_of(before.velocities, fluid);
    return before;
  }



  template <int dim>
  void Accounts<dim>::solved(const BeforeMove &before, const std::vector<double> &left_out,
                             const Fluid &fluid)
  {
    std::vector<double> growth(left_out.size());
    Utilities::MPI::sum(left_out, fluid.communicator, growth);
    volume.solved(volume_of(fluid), fluid.inlets.volume(), std::accumulate(growth.begin(), growth.end(), 0.));
    std::vector<double> inflow;
    for (unsigned int f = 0; f < fluid.materials.n_fluids(); ++f)
      inflow.push_back(fluid.inlets.volume(f));
    fluids.solved(volumes_of(fluid), inflow, growth);
    momentum.solved(momentum_of(before.velocities, fluid) - before.momentum);
    momentum.set(momentum_of(fluid));
  }



  template <int dim>
  void Accounts<dim>::rearranged(const Fluid &fluid)
  {
    momentum.changed(momentum_of(fluid));
  }



  template <int dim>
  double Accounts<dim>::volume_of(const Fluid &fluid)
  {
    return Utilities::MPI::sum(fluid.mesh.volume(fluid.cloud) +
                                 VolumeCorrection<dim>::carried_volume(fluid.mesh, fluid.cloud) +
                                 fluid.inlets.layer_volume(fluid.cloud, fluid.mesh),
                               fluid.communicator);
  }



  template <int dim>
  std::vector<double> Accounts<dim>::volumes_of(const Fluid &fluid)
  {
    const unsigned int n_fluids = fluid.materials.n_fluids();
    if (n_fluids == 1)
      return {};
    std::vector<double> result        = fluid.mesh.volumes(fluid.cloud, n_fluids);
    const std::vector<double> carried = VolumeCorrection<dim>::carried_volumes(fluid.mesh, fluid.cloud,
                                                                               n_fluids);
    for (unsigned int f = 0; f < n_fluids; ++f)
      result[f] += carried[f] + fluid.inlets.layer_volume(fluid.cloud, fluid.mesh, f);
    Utilities::MPI::sum(result, fluid.communicator, result);
    return result;
  }



  template <int dim>
  typename MomentumAccount<dim>::Momenta Accounts<dim>::momentum_of(const Fluid &fluid) const
  {
    return momentum.compute(fluid.mesh, fluid.cloud, fluid.materials, fluid.communicator);
  }



  template <int dim>
  Tensor<1, dim> Accounts<dim>::momentum_of(const std::vector<Tensor<1, dim>> &velocities, const Fluid &fluid)
  {
    return MomentumAccount<dim>::integrate(velocities, fluid.mesh, fluid.cloud, fluid.materials,
                                           fluid.communicator);
  }



  template struct Accounts<2>;
  template struct Accounts<3>;
} // namespace Lahar
