// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <lahar/simulator/solid_step.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  void SolidStep<dim>::start(const Solids<dim> &new_solids, const FluidMesh<dim> &mesh,
                             const TimeIntegration &new_integration, const double end_time)
  {
    solids = &new_solids;
    system_nodes.clear();
    own_nodes.clear();
    n_vertices = mesh.n_vertices();
    if (solids->empty())
      return;
    integration     = new_integration;
    external_forces = solids->external_forces(end_time);

    // The solids' particles come first in the cloud, and so among the vertices.
    const SolidMesh<dim> &solid_mesh = solids->mesh();
    system_nodes.assign(solid_mesh.n_nodes(), numbers::invalid_unsigned_int);
    for (unsigned int v = 0; v < n_vertices && mesh.particle(v) < solid_mesh.n_contour_nodes(); ++v)
      system_nodes[mesh.particle(v)] = v;
    for (unsigned int i = 0; i < system_nodes.size(); ++i)
      if (system_nodes[i] == numbers::invalid_unsigned_int)
      {
        system_nodes[i] = n_vertices + own_nodes.size();
        own_nodes.push_back(i);
      }

    state           = solids->state();
    mean_velocities = state.velocity;
    for (unsigned int i = 0; i < solid_mesh.n_nodes(); ++i)
      if (solids->is_fixed(i))
        mean_velocities[i] = solids->prescribed_velocity(i, end_time - 0.5 * integration.length());
  }



  template <int dim>
  std::vector<unsigned int> SolidStep<dim>::cells() const
  {
    std::vector<unsigned int> result;
    if (!system_nodes.empty())
      for (const unsigned int node : solids->mesh().cell_nodes())
        result.push_back(system_nodes[node]);
    return result;
  }



  template <int dim>
  std::vector<std::pair<unsigned int, unsigned int>>
  SolidStep<dim>::known_nodes(const NodePartition &partition) const
  {
    std::vector<std::pair<unsigned int, unsigned int>> result;
    for (unsigned int i = 0; i < system_nodes.size(); ++i)
      if (partition.local(system_nodes[i]) != numbers::invalid_unsigned_int)
        result.emplace_back(partition.local(system_nodes[i]), i);
    return result;
  }



  template <int dim>
  NodeConstraint<dim> SolidStep<dim>::constraint(const unsigned int node) const
  {
    NodeConstraint<dim> result;
    result.n_fixed = solids->is_fixed(node) ? dim : 0;
    return result;
  }



  template <int dim>
  std::vector<Tensor<1, dim>> SolidStep<dim>::gather(const NodePartition &partition,
                                                     const std::vector<Tensor<1, dim>> &values) const
  {
    if (system_nodes.empty())
      return {};
    std::vector<std::pair<unsigned int, Tensor<1, dim>>> own;
    for (const auto &[l, i] : known_nodes(partition))
      if (l < partition.n_own())
        own.emplace_back(i, values[l]);
    std::vector<Tensor<1, dim>> result(system_nodes.size());
    if (Utilities::MPI::n_mpi_processes(partition.communicator()) == 1)
      for (const auto &[i, value] : own)
        result[i] = value;
    else
      for (const auto &of_rank : Utilities::MPI::all_gather(partition.communicator(), own))
        for (const auto &[i, value] : of_rank)
          result[i] = value;
    return result;
  }



  template <int dim>
  void SolidStep<dim>::move(const std::vector<Tensor<1, dim>> &new_mean_velocities)
  {
    mean_velocities            = new_mean_velocities;
    const SolidState<dim> &old = solids->state();
    for (unsigned int i = 0; i < system_nodes.size(); ++i)
    {
      const Motion<dim> end             = integration.end_of_step<dim>(mean_velocities[i],
                                                           {old.velocity[i], old.acceleration[i],
                                                                        old.algorithmic_acceleration[i]},
                                                           solids->is_fixed(i));
      state.velocity[i]                 = end.velocity;
      state.acceleration[i]             = end.acceleration;
      state.algorithmic_acceleration[i] = end.algorithmic_acceleration;
      state.position[i]                 = old.position[i] + integration.length() * mean_velocities[i];
    }
  }



  template <int dim>
  void SolidStep<dim>::get_positions(std::vector<Point<dim>> &positions) const
  {
    for (unsigned int i = 0; i < system_nodes.size(); ++i)
      positions[system_nodes[i]] = state.position[i];
  }



  template <int dim>
  bool SolidStep<dim>::assemble(const Tensor<1, dim> &gravity, BlockSystem<dim> &system) const
  {
    return system_nodes.empty() ||
           assembler.assemble(*solids, state, {integration.length(), integration.acceleration_factor(false)},
                              {gravity, external_forces}, system_nodes, system);
  }



  template <int dim>
  double SolidStep<dim>::speed_of_sound() const
  {
    double speed = 0.;
    if (!system_nodes.empty())
      for (const SolidBody<dim> &body : solids->all_bodies())
        speed = std::max(speed, std::sqrt((body.law->bulk_modulus() + 4. / 3. * body.law->shear_modulus()) /
                                          body.law->density()));
    return speed;
  }



  template <int dim>
  void SolidStep<dim>::accept(const std::vector<Tensor<1, dim>> &forces, Solids<dim> &target)
  {
    if (system_nodes.empty())
      return;
    for (unsigned int i = 0; i < forces.size(); ++i)
      state.reaction[i] = integration.mean_force(forces[i], target.state().reaction[i]);
    assembler.update_stress(target, state);
    target.accept(state);
  }



  template class SolidStep<2>;
  template class SolidStep<3>;
} // namespace Lahar
