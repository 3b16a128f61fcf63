// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/symmetry.h>
#include <lahar/simulator/fluid_step.h>
#include <lahar/simulator/slivers.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// A cell keeps this part of its volume in every iteration.
    constexpr double smallest_volume_ratio = 0.2;

    /// Mean velocities are expected to be v_n + this part of Δt dv/dt.
    constexpr double predicted_part = 0.5;
  } // namespace



  template <int dim>
  void FluidStep<dim>::start(const FluidMesh<dim> &new_mesh, const ParticleCloud<dim> &cloud,
                             const TimeIntegration &new_integration, const Tensor<1, dim> &gravity,
                             const IndexVector<Vertex, bool> &new_impulsive)
  {
    mesh              = &new_mesh;
    integration       = new_integration;
    impulsive         = new_impulsive;
    const auto gather = [&](const auto &of_cloud, auto &of_vertices) {
      of_vertices.resize(mesh->n_vertices());
      for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
        of_vertices[v] = of_cloud[mesh->particle(v)];
    };
    gather(cloud.position, state.old_position);
    gather(cloud.velocity, state.old_velocity);
    gather(cloud.acceleration, state.old_acceleration);
    gather(cloud.algorithmic_acceleration, state.old_algorithmic_acceleration);
    gather(cloud.pressure, state.old_pressure);
    gather(cloud.pressure_rate, state.old_pressure_rate);
    state.time_step = integration.length();
    state.gravity   = gravity;
    state.sliver    = find_slivers(*mesh, cloud);
    state.velocity_factor.resize(mesh->n_vertices());
    state.acceleration_factor.resize(mesh->n_vertices());
    state.mean_velocity = state.old_velocity;
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      state.velocity_factor[v]     = integration.velocity_factor(impulsive[Vertex(v)]);
      state.acceleration_factor[v] = integration.acceleration_factor(impulsive[Vertex(v)]);
      if (!impulsive[Vertex(v)])
        state.mean_velocity[v] += predicted_part * state.time_step * state.old_acceleration[v];
    }
    state.pressure                 = state.old_pressure;
    state.velocity                 = state.old_velocity;
    state.position                 = state.old_position;
    state.acceleration             = state.old_acceleration;
    state.algorithmic_acceleration = state.old_algorithmic_acceleration;
  }



  template <int dim>
  void FluidStep<dim>::move(const IndexVector<Vertex, Tensor<1, dim>> &mean_velocities)
  {
    AssertDimension(mean_velocities.size(), mesh->n_vertices());
    state.mean_velocity = mean_velocities.raw();
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      const Motion<dim> end             = integration.end_of_step<dim>(state.mean_velocity[v],
                                                           {state.old_velocity[v], state.old_acceleration[v],
                                                                        state.old_algorithmic_acceleration[v]},
                                                           impulsive[Vertex(v)]);
      state.velocity[v]                 = end.velocity;
      state.acceleration[v]             = end.acceleration;
      state.algorithmic_acceleration[v] = end.algorithmic_acceleration;
      state.position[v]                 = state.old_position[v] + state.time_step * state.mean_velocity[v];
    }
  }



  template <int dim>
  std::vector<double> FluidStep<dim>::volumes(const std::vector<Point<dim>> &positions) const
  {
    std::vector<double> result;
    result.reserve(mesh->n_cells());
    for (const Simplex<dim> &cell : mesh->cells())
      result.push_back(body_volume<dim>(corners_of<dim>(cell, positions)));
    return result;
  }



  template <int dim>
  std::vector<unsigned int> FluidStep<dim>::shrinking_cells(const std::vector<double> &from) const
  {
    std::vector<unsigned int> cells;
    const std::vector<double> to = new_volumes();
    for (unsigned int c = 0; c < mesh->n_cells(); ++c)
      if (!(to[c] > smallest_volume_ratio * from[c]) && !state.left_out[c] && !state.sliver[c])
        cells.push_back(c);
    return cells;
  }



  template <int dim>
  std::vector<Vertex> FluidStep<dim>::shrinking_vertices(const std::vector<double> &from) const
  {
    std::vector<Vertex> vertices;
    for (const unsigned int c : shrinking_cells(from))
      for (const unsigned int v : mesh->cells()[c])
        vertices.push_back(Vertex(v));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }



  template <int dim>
  void FluidStep<dim>::accept(ParticleCloud<dim> &cloud) const
  {
    for (unsigned int v = 0; v < mesh->n_vertices(); ++v)
    {
      const unsigned int i              = mesh->particle(v);
      cloud.position[i]                 = state.position[v];
      cloud.velocity[i]                 = state.velocity[v];
      cloud.acceleration[i]             = state.acceleration[v];
      cloud.algorithmic_acceleration[i] = state.algorithmic_acceleration[v];
      cloud.pressure_rate[i]            = (state.pressure[v] - state.old_pressure[v]) / state.time_step;
      cloud.pressure[i]                 = state.pressure[v];
    }
  }



  template class FluidStep<2>;
  template class FluidStep<3>;
} // namespace Lahar
