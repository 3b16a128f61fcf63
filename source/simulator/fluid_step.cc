// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/remeshing/simplex_geometry.h>
#include <lahar/simulator/fluid_step.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// A cell keeps this part of its volume in every iteration.
    constexpr double smallest_volume_ratio = 0.2;
  } // namespace



  template <int dim>
  void FluidStep<dim>::start(const FluidMesh<dim> &new_mesh, const ParticleCloud<dim> &cloud,
                             const TimeIntegration &new_integration, const std::vector<bool> &arrives)
  {
    mesh              = &new_mesh;
    integration       = new_integration;
    const auto gather = [&](const auto &of_cloud, auto &of_vertices) {
      of_vertices.resize(mesh->n_vertices());
      for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
        of_vertices[v] = of_cloud[mesh->particle(v)];
    };
    gather(cloud.position, state.old_position);
    gather(cloud.velocity, state.old_velocity);
    gather(cloud.acceleration, state.old_acceleration);
    gather(cloud.pressure, state.old_pressure);
    gather(cloud.pressure_rate, state.old_pressure_rate);
    state.factors = integration.factors();
    state.position_factor.resize(mesh->n_vertices());
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
      state.position_factor[v] = integration.position_factor(arrives[v] && cloud.kind[mesh->particle(v)] !=
                                                                             ParticleKind::solid);
    state.pressure     = state.old_pressure;
    state.velocity     = state.old_velocity;
    state.position     = state.old_position;
    state.acceleration = state.old_acceleration;
  }



  template <int dim>
  void FluidStep<dim>::move(const std::vector<Tensor<1, dim>> &velocities)
  {
    AssertDimension(velocities.size(), mesh->n_vertices());
    state.velocity = velocities;
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      state.acceleration[v] = integration.acceleration(state.velocity[v], state.old_velocity[v],
                                                       state.old_acceleration[v]);
      state.position[v]     = state.old_position[v] + integration.displacement(state.velocity[v],
                                                                               state.old_velocity[v],
                                                                               state.position_factor[v]);
    }
  }



  template <int dim>
  Tensor<1, dim> FluidStep<dim>::slowed_velocity(const unsigned int v, const double part) const
  {
    const double rest = state.factors.time_step / state.position_factor[v] - 1.;
    return (part * (1. + rest) - rest) * state.old_velocity[v];
  }



  template <int dim>
  std::vector<double> FluidStep<dim>::volumes(const std::vector<Point<dim>> &positions) const
  {
    std::vector<double> result;
    result.reserve(mesh->n_cells());
    for (const Simplex<dim> &cell : mesh->cells())
      result.push_back(signed_volume<dim>(corners_of<dim>(cell, positions)));
    return result;
  }



  template <int dim>
  std::vector<unsigned int> FluidStep<dim>::shrinking_cells(const std::vector<double> &from) const
  {
    std::vector<unsigned int> cells;
    const std::vector<double> to = new_volumes();
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      if (!(to[c] > smallest_volume_ratio * from[c]) && !state.left_out[c])
        cells.push_back(c);
    return cells;
  }



  template <int dim>
  std::vector<unsigned int> FluidStep<dim>::shrinking_vertices(const std::vector<double> &from) const
  {
    std::vector<unsigned int> vertices;
    for (const unsigned int c : shrinking_cells(from))
      vertices.insert(vertices.end(), mesh->cells()[c].begin(), mesh->cells()[c].end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }



  template <int dim>
  void FluidStep<dim>::accept(ParticleCloud<dim> &cloud) const
  {
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      const unsigned int i   = mesh->particle(v);
      cloud.position[i]      = state.position[v];
      cloud.velocity[i]      = state.velocity[v];
      cloud.acceleration[i]  = state.acceleration[v];
      cloud.pressure_rate[i] = (state.pressure[v] - state.old_pressure[v]) / state.factors.time_step;
      cloud.pressure[i]      = state.pressure[v];
    }
  }



  template class FluidStep<2>;
  template class FluidStep<3>;
} // namespace Lahar
