// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_fluid_step_h
#define lahar_simulator_fluid_step_h

#include <lahar/assembly/fluid_state.h>
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
     * Begin a step with the state of the mesh's particles; the end is set to the start.
     * @param arrives by vertex: whether it is a corner of a cell that has just become fluid, see TimeIntegration.
     */
    void start(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
               const TimeIntegration &integration, const std::vector<bool> &arrives);

    /// Set the velocities at the end of the step, by vertex, and what follows from them.
    void move(const std::vector<Tensor<1, dim>> &velocities);

    /**
     * The velocity of vertex @p v, not a wall's or a solid's, with which it moves @p part of the way that it would with
     * its old one; with none of the way it stays where it is.
     */
    Tensor<1, dim> slowed_velocity(const unsigned int v, const double part) const;

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
    std::vector<unsigned int> shrinking_vertices(const std::vector<double> &from) const;

    /// Write the end of the step to the mesh's particles.
    void accept(ParticleCloud<dim> &cloud) const;

    FluidState<dim> state;

  private:
    std::vector<double> volumes(const std::vector<Point<dim>> &positions) const;

    const FluidMesh<dim> *mesh = nullptr;
    TimeIntegration integration;
  };
} // namespace Lahar

#endif
