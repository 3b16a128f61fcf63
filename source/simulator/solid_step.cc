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
    n_own = n_shared = 0;
    n_vertices       = mesh.n_vertices();
    if (solids->empty())
      return;
    integration     = new_integration;
    external_forces = solids->external_forces(end_time);

    // The solids' particles come first in the cloud, and so among the vertices.
    const SolidMesh<dim> &solid_mesh = solids->mesh();
    system_nodes.assign(solid_mesh.n_nodes(), numbers::invalid_unsigned_int);
    for (; n_shared < n_vertices && mesh.particle(n_shared) < solid_mesh.n_contour_nodes(); ++n_shared)
      system_nodes[mesh.particle(n_shared)] = n_shared;
    for (unsigned int &node : system_nodes)
      if (node == numbers::invalid_unsigned_int)
        node = n_vertices + n_own++;

    state = solids->state();
    for (unsigned int i = 0; i < solid_mesh.n_nodes(); ++i)
      if (solids->is_fixed(i))
        state.velocity[i] = solids->prescribed_velocity(i, end_time);
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
    const std::vector<double> gathered = partition.gather(reinterpret_cast<const double *>(values.data()),
                                                          dim,
                                                          {{0, n_shared}, {n_vertices, n_vertices + n_own}});
    std::vector<Tensor<1, dim>> result(system_nodes.size());
    for (unsigned int i = 0; i < system_nodes.size(); ++i)
    {
      const unsigned int node  = system_nodes[i];
      const std::size_t number = node < n_vertices ? node : n_shared + node - n_vertices;
      for (unsigned int a = 0; a < dim; ++a)
        result[i][a] = gathered[dim * number + a];
    }
    return result;
  }



  template <int dim>
  void SolidStep<dim>::move(const std::vector<Tensor<1, dim>> &velocities)
  {
    const SolidState<dim> &old = solids->state();
    for (unsigned int i = 0; i < system_nodes.size(); ++i)
    {
      state.velocity[i]     = velocities[i];
      state.acceleration[i] = integration.acceleration(state.velocity[i], old.velocity[i],
                                                       old.acceleration[i]);
      state.position[i]     = old.position[i] + integration.displacement(state.velocity[i], old.velocity[i],
                                                                         integration.position_factor(false));
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
           assembler.assemble(*solids, state,
                              {integration.position_factor(false), integration.factors().acceleration_factor},
                              gravity, external_forces, system_nodes, system);
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
  void SolidStep<dim>::accept(Solids<dim> &target)
  {
    if (system_nodes.empty())
      return;
    assembler.update_stress(target, state);
    target.accept(state);
  }



  template class SolidStep<2>;
  template class SolidStep<3>;
} // namespace Lahar
