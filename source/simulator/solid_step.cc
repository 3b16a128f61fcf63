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
    region_nodes.clear();
    own_nodes.clear();
    n_vertices = mesh.n_vertices();
    if (solids->empty())
      return;
    integration     = new_integration;
    external_forces = solids->external_forces(end_time);

    // The solids' particles come first in the cloud, and so among the vertices.
    const SolidMesh<dim> &solid_mesh = solids->mesh();
    region_nodes.assign(solid_mesh.n_nodes(), RegionNode());
    for (unsigned int v = 0; v < n_vertices && mesh.particle(v) < solid_mesh.n_contour_nodes(); ++v)
      region_nodes[SolidNode(mesh.particle(v))] = RegionNode(v);
    for (const SolidNode i : region_nodes.indices())
      if (!region_nodes[i].is_valid())
      {
        region_nodes[i] = RegionNode(n_vertices + own_nodes.size());
        own_nodes.push_back(i);
      }

    state           = solids->state();
    mean_velocities = IndexVector<SolidNode, Tensor<1, dim>>(state.velocity);
    for (const SolidNode i : mean_velocities.indices())
      if (solids->is_fixed(i.value()))
        mean_velocities[i] = solids->prescribed_velocity(i.value(), end_time - 0.5 * integration.length());
  }



  template <int dim>
  std::vector<unsigned int> SolidStep<dim>::cells() const
  {
    std::vector<unsigned int> result;
    if (!region_nodes.empty())
      for (const unsigned int node : solids->mesh().cell_nodes())
        result.push_back(region_nodes[SolidNode(node)].value());
    return result;
  }



  template <int dim>
  NodeConstraint<dim> SolidStep<dim>::constraint(const SolidNode node) const
  {
    NodeConstraint<dim> result;
    result.n_fixed = solids->is_fixed(node.value()) ? dim : 0;
    return result;
  }



  template <int dim>
  IndexVector<SolidNode, Tensor<1, dim>>
  SolidStep<dim>::gather(const Numbering &numbering, const MPI_Comm &communicator,
                         const IndexVector<LocalNode, Tensor<1, dim>> &values) const
  {
    IndexVector<SolidNode, Tensor<1, dim>> result(region_nodes.size());
    if (region_nodes.empty())
      return result;
    std::vector<std::pair<unsigned int, Tensor<1, dim>>> own;
    for (const auto &[node, i] : numbering.solid_nodes())
      if (numbering.is_own(node))
        own.emplace_back(i.value(), values[node]);
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      for (const auto &[i, value] : own)
        result[SolidNode(i)] = value;
    else
      for (const auto &of_rank : Utilities::MPI::all_gather(communicator, own))
        for (const auto &[i, value] : of_rank)
          result[SolidNode(i)] = value;
    return result;
  }



  template <int dim>
  void SolidStep<dim>::move(const IndexVector<SolidNode, Tensor<1, dim>> &new_mean_velocities)
  {
    mean_velocities            = new_mean_velocities;
    const SolidState<dim> &old = solids->state();
    for (unsigned int i = 0; i < region_nodes.size(); ++i)
    {
      const Motion<dim> end             = integration.end_of_step<dim>(mean_velocities[SolidNode(i)],
                                                           {old.velocity[i], old.acceleration[i],
                                                                        old.algorithmic_acceleration[i]},
                                                           solids->is_fixed(i));
      state.velocity[i]                 = end.velocity;
      state.acceleration[i]             = end.acceleration;
      state.algorithmic_acceleration[i] = end.algorithmic_acceleration;
      state.position[i] = old.position[i] + integration.length() * mean_velocities[SolidNode(i)];
    }
  }



  template <int dim>
  void SolidStep<dim>::get_positions(IndexVector<RegionNode, Point<dim>> &positions) const
  {
    for (const SolidNode i : region_nodes.indices())
      positions[region_nodes[i]] = state.position[i.value()];
  }



  template <int dim>
  bool SolidStep<dim>::assemble(const Tensor<1, dim> &gravity, BlockSystem<dim> &system) const
  {
    return region_nodes.empty() ||
           assembler.assemble(*solids, state, {integration.length(), integration.acceleration_factor(false)},
                              {gravity, external_forces}, region_nodes, system);
  }



  template <int dim>
  double SolidStep<dim>::speed_of_sound() const
  {
    double speed = 0.;
    if (!region_nodes.empty())
      for (const SolidBody<dim> &body : solids->all_bodies())
        speed = std::max(speed, std::sqrt((body.law->bulk_modulus() + 4. / 3. * body.law->shear_modulus()) /
                                          body.law->density()));
    return speed;
  }



  template <int dim>
  void SolidStep<dim>::accept(const IndexVector<SolidNode, Tensor<1, dim>> &forces, Solids<dim> &target)
  {
    if (region_nodes.empty())
      return;
    for (const SolidNode i : forces.indices())
      state.reaction[i.value()] = integration.mean_force(forces[i], target.state().reaction[i.value()]);
    assembler.update_stress(target, state);
    target.accept(state);
  }



  template class SolidStep<2>;
  template class SolidStep<3>;
} // namespace Lahar
