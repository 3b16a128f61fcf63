// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_fluid_step_h
#define lahar_simulator_fluid_step_h

#include <lahar/assembly/fluid_state.h>
#include <lahar/linear/numbering.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/simulator/time_integration.h>

#include <vector>

namespace Lahar
{
  /**
   * The fluid during one time step: its state at the start and at the end, by vertex of the mesh, and the motion of its
   * simplices in between. On several ranks: of the part of the mesh that a rank knows.
   */
  template <int dim>
  class FluidStep
  {
  public:
    /**
     * Begin a step with the state of the mesh's particles; the end is set to the start, the mean velocities to those that
     * the accelerations at the start let expect.
     * @param gravity m/s². @param impulsive whether a vertex moves impulsively, see TimeIntegration.
     */
    void start(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
               const TimeIntegration &integration, const Tensor<1, dim> &gravity,
               const IndexVector<Vertex, bool> &impulsive);

    /// Set the mean velocities in the step, and what follows from them.
    void move(const IndexVector<Vertex, Tensor<1, dim>> &mean_velocities);

    /// Volumes of the cells at the start and at the end of the step, m³ (m² in the plane).
    std::vector<double> old_volumes() const
    {
      return volumes(state.old_position);
    }
    std::vector<double> new_volumes() const
    {
      return volumes(state.position);
    }

    /// The cells that are inverted or have less than a fifth of the volumes @p from, but those that are left out.
    std::vector<unsigned int> shrinking_cells(const std::vector<double> &from) const;

    /// Their vertices, ascending.
    std::vector<Vertex> shrinking_vertices(const std::vector<double> &from) const;

    /// Write the end of the step to the mesh's particles.
    void accept(ParticleCloud<dim> &cloud) const;

    FluidState<dim> state;

  private:
    std::vector<double> volumes(const std::vector<Point<dim>> &positions) const;

    const FluidMesh<dim> *mesh = nullptr;
    TimeIntegration integration;
    IndexVector<Vertex, bool> impulsive;
  };
} // namespace Lahar

#endif
