// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_solid_step_h
#define lahar_simulator_solid_step_h

#include <lahar/assembly/solid_assembler.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/simulator/time_integration.h>

#include <vector>

namespace Lahar
{
  /**
   * The solids during one time step: their state at its end, and their place in the system of unknowns.
   *
   * The velocity of a contour node that is a vertex of the fluid's mesh is that vertex's: one unknown for both. All
   * other nodes follow the fluid's vertices in the system.
   */
  template <int dim>
  class SolidStep
  {
  public:
    /// Begin a step of @p solids that ends at @p end_time, with the velocities of its start or the prescribed ones as mean ones.
    void start(const Solids<dim> &solids, const FluidMesh<dim> &mesh, const TimeIntegration &integration,
               const double end_time);

    /// Nodes that are no vertex of the fluid's mesh.
    unsigned int n_own_nodes() const
    {
      return own_nodes.size();
    }

    /// The system's number of each node.
    const std::vector<unsigned int> &nodes() const
    {
      return system_nodes;
    }

    /// The cells by the system's numbers, as BlockSystem wants them.
    std::vector<unsigned int> cells() const;

    unsigned int nodes_per_cell() const
    {
      return system_nodes.empty() ? 0 : solids->mesh().nodes_per_cell();
    }

    /// The solids' nodes that @p partition knows: their local numbers there and their own.
    std::vector<std::pair<unsigned int, unsigned int>> known_nodes(const NodePartition &partition) const;

    /// What is prescribed at a node.
    NodeConstraint<dim> constraint(const unsigned int node) const;

    /// Collect on all ranks the values of the solids' nodes, which the owners have in @p values by local number.
    std::vector<Tensor<1, dim>> gather(const NodePartition &partition,
                                       const std::vector<Tensor<1, dim>> &values) const;

    /// Set the mean velocities of all nodes in the step, and what follows from them.
    void move(const std::vector<Tensor<1, dim>> &mean_velocities);

    const Tensor<1, dim> &mean_velocity(const unsigned int node) const
    {
      return mean_velocities[node];
    }

    const Point<dim> &position(const unsigned int node) const
    {
      return state.position[node];
    }

    /// Node of the solids, by the system's number of one that is no vertex.
    unsigned int solid_node(const unsigned int system_node) const
    {
      return own_nodes[system_node - n_vertices];
    }

    /// Write the positions into those of all the system's nodes.
    void get_positions(std::vector<Point<dim>> &positions) const;

    /// Add to the system. @return whether all cells have positive volume.
    bool assemble(const Tensor<1, dim> &gravity, BlockSystem<dim> &system) const;

    /// The largest speed of sound, m/s; zero without solids.
    double speed_of_sound() const;

    /// Make the state the solids' own. @param forces by node, of fluid and supports at the end of the step, N.
    void accept(const std::vector<Tensor<1, dim>> &forces, Solids<dim> &target);

  private:
    const Solids<dim> *solids = nullptr;
    SolidAssembler<dim> assembler;
    TimeIntegration integration;
    std::vector<unsigned int> system_nodes, own_nodes; ///< the latter: that are no vertices
    unsigned int n_vertices = 0;
    std::vector<Tensor<1, dim>> external_forces;
    SolidState<dim> state;
    std::vector<Tensor<1, dim>> mean_velocities;
  };
} // namespace Lahar

#endif
