// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_sliding_friction_h
#define lahar_simulator_sliding_friction_h

#include <lahar/boundary/sliding_contact.h>
#include <lahar/linear/block_system.h>
#include <lahar/linear/numbering.h>
#include <lahar/material/materials.h>
#include <lahar/simulator/solid_contact.h>

#include <vector>

namespace Lahar
{
  /**
   * The friction along boundaries during one time step, at the vertices that slide.
   *
   * What it adds to the system is no part of BlockSystem::momentum_residual(), so that the reaction of a vertex that slides
   * is the force of the boundary with its friction. Along a solid s is relative to the facet's point below the vertex, and
   * the opposite force acts on the facet's corners, see SolidContact; that they feel the pressure's increment is no part of
   * the tangent.
   */
  template <int dim>
  class SlidingFriction
  {
  public:
    /// The region at the start of a step.
    struct Start
    {
      const FluidMesh<dim> &mesh;
      const ParticleCloud<dim> &cloud;
      const Materials &materials;
      const Tensor<1, dim> &gravity; ///< m/s²
      double time_step;              ///< s
    };

    /**
     * Begin a step with the @p contacts of the region's mesh. Multipliers and reactions are those of the particles; each
     * contact's stiffness becomes 20 ρ h/Δt + 5 μ/h, h the particle's spacing and μ the viscous part at the strain rate
     * 1/Δt: sliding that must stop then does so within few steps, whatever moves behind the vertex. Its pore pressure is
     * the largest one of all fluids, so that friction does not hold the water beside the grains either. Collective.
     */
    void start_step(const std::vector<SlidingContact<dim>> &contacts, const Start &start,
                    const Numbering &numbering, const MPI_Comm &communicator);

    /// Take part in the contacts with solids, once they are numbered.
    void join(const SolidContact<dim> &solids);

    /// Follow the solids' present velocities.
    void move(const SolidContact<dim> &solids);

    /// Add forces and tangents to @p system at the mean @p velocities (m/s) and the @p pressures (Pa) of the nodes.
    void assemble(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                  const IndexVector<LocalNode, double> &pressures, const SolidContact<dim> &solids,
                  BlockSystem<dim> &system) const;

    /// What the vertices of contacts with solids exert along these, by contact, N.
    std::vector<Tensor<1, dim>> forces_on_solids(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                                                 const IndexVector<LocalNode, double> &pressures,
                                                 const SolidContact<dim> &solids) const;

    /// End an iteration, see SlidingContact. @param reactions of the boundaries on the nodes, as the last assembly has
    /// them.
    void iterate(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                 const IndexVector<LocalNode, double> &pressures,
                 const IndexVector<LocalNode, Tensor<1, dim>> &reactions);

    /// Whether no vertex of this rank is held for an iteration.
    bool is_settled() const;

    /// End the step: λ = P, which the particles of the region's mesh keep; what does not slide has none.
    void accept(const IndexVector<LocalNode, Tensor<1, dim>> &velocities,
                const IndexVector<LocalNode, double> &pressures, const FluidMesh<dim> &mesh,
                ParticleCloud<dim> &cloud) const;

    /// Whether anything slides with friction on any rank.
    bool any() const
    {
      return is_any;
    }

  private:
    struct Contact
    {
      SlidingContact<dim> at; ///< with the vertex of the region's mesh
      LocalNode node;
      SlidingState<dim> state;
      bool is_main;                                            ///< whether the particle keeps its multiplier
      unsigned int with_solid = numbers::invalid_unsigned_int; ///< number of a contact with a solid
    };

    std::vector<Contact> contacts; ///< of the nodes that this rank knows
    bool is_any               = false;
    unsigned int n_iterations = 0; ///< of the step
  };
} // namespace Lahar

#endif
