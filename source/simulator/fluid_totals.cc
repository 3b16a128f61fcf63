// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/volume_correction.h>
#include <lahar/simulator/simulator.h>

namespace Lahar
{
  template <int dim>
  double Simulator<dim>::fluid_volume() const
  {
    return sum_of_ranks(fluid_mesh.volume(particles) +
                        VolumeCorrection<dim>::carried_volume(fluid_mesh, particles) +
                        inlets.layer_volume(particles, fluid_mesh));
  }



  template <int dim>
  std::vector<double> Simulator<dim>::fluid_volumes() const
  {
    const unsigned int n_fluids = materials.n_fluids();
    if (n_fluids == 1)
      return {};
    std::vector<double> result        = fluid_mesh.volumes(particles, n_fluids);
    const std::vector<double> carried = VolumeCorrection<dim>::carried_volumes(fluid_mesh, particles,
                                                                               n_fluids);
    for (unsigned int f = 0; f < n_fluids; ++f)
      result[f] += carried[f] + inlets.layer_volume(particles, fluid_mesh, f);
    Utilities::MPI::sum(result, communicator(), result);
    return result;
  }



  template <int dim>
  std::vector<double> Simulator<dim>::inflow_volumes() const
  {
    std::vector<double> result;
    for (unsigned int f = 0; f < materials.n_fluids(); ++f)
      result.push_back(inlets.volume(f));
    return result;
  }



  template <int dim>
  Tensor<1, dim> Simulator<dim>::fluid_momentum() const
  {
    return account.momentum.compute(fluid_mesh, particles, materials, communicator());
  }



  template double Simulator<2>::fluid_volume() const;
  template double Simulator<3>::fluid_volume() const;
  template std::vector<double> Simulator<2>::fluid_volumes() const;
  template std::vector<double> Simulator<3>::fluid_volumes() const;
  template std::vector<double> Simulator<2>::inflow_volumes() const;
  template std::vector<double> Simulator<3>::inflow_volumes() const;
  template Tensor<1, 2> Simulator<2>::fluid_momentum() const;
  template Tensor<1, 3> Simulator<3>::fluid_momentum() const;
} // namespace Lahar
