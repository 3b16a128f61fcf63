// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_solid_step_h
#define lahar_simulator_solid_step_h

#include <lahar/assembly/solid_assembler.h>
#include <lahar/linear/numbering.h>
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

    /// The region's node of each node.
    const IndexVector<SolidNode, RegionNode> &nodes() const
    {
      return region_nodes;
    }

    /// The cells by the region's nodes, as BlockSystem wants them.
    std::vector<unsigned int> cells() const;

    unsigned int nodes_per_cell() const
    {
      return region_nodes.empty() ? 0 : solids->mesh().nodes_per_cell();
    }

    /// What is prescribed at a node.
    NodeConstraint<dim> constraint(const SolidNode node) const;

    /// Collect on all ranks the values of the solids' nodes, which the owners have in @p values.
    IndexVector<SolidNode, Tensor<1, dim>> gather(const Numbering &numbering, const MPI_Comm &communicator,
                                                  const IndexVector<LocalNode, Tensor<1, dim>> &values) const;

    /// Set the mean velocities of all nodes in the step, and what follows from them.
    void move(const IndexVector<SolidNode, Tensor<1, dim>> &mean_velocities);

    const Tensor<1, dim> &mean_velocity(const SolidNode node) const
    {
      return mean_velocities[node];
    }

    const Point<dim> &position(const SolidNode node) const
    {
      return state.position[node.value()];
    }

    /// Node of the solids, by the region's of one that is no vertex.
    SolidNode solid_node(const RegionNode node) const
    {
      return own_nodes[node.value() - n_vertices];
    }

    /// Write the positions into those of all the region's nodes.
    void get_positions(IndexVector<RegionNode, Point<dim>> &positions) const;

    /// Add to the system. @return whether all cells have positive volume.
    bool assemble(const Tensor<1, dim> &gravity, BlockSystem<dim> &system) const;

    /// The largest speed of sound, m/s; zero without solids.
    double speed_of_sound() const;

    /// Make the state the solids' own. @param forces of fluid and supports at the end of the step, N.
    void accept(const IndexVector<SolidNode, Tensor<1, dim>> &forces, Solids<dim> &target);

  private:
    const Solids<dim> *solids = nullptr;
    SolidAssembler<dim> assembler;
    TimeIntegration integration;
    IndexVector<SolidNode, RegionNode> region_nodes;
    std::vector<SolidNode> own_nodes; ///< that are no vertices
    unsigned int n_vertices = 0;
    std::vector<Tensor<1, dim>> external_forces;
    SolidState<dim> state;
    IndexVector<SolidNode, Tensor<1, dim>> mean_velocities;
  };
} // namespace Lahar

#endif
