// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_sliding_friction_h
#define lahar_simulator_sliding_friction_h

#include <lahar/boundary/sliding_contact.h>
#include <lahar/linear/block_system.h>
#include <lahar/material/fluid_law.h>

#include <vector>

namespace Lahar
{
  /**
   * The friction along boundaries during one time step, at the vertices that slide.
   *
   * What it adds to the system is no part of BlockSystem::momentum_residual(), so that the reaction of a vertex that slides
   * is the force of the boundary with its friction.
   */
  template <int dim>
  class SlidingFriction
  {
  public:
    /**
     * Begin a step of length @p time_step (s) with the @p contacts of the region's mesh, whose vertices are the first
     * nodes. The multipliers are those of the particles; each contact's stiffness becomes 100 ρ h/Δt + 30 μ/h, h the
     * particle's spacing and μ the viscous part at the strain rate 1/Δt: sliding that must stop then does so within few
     * iterations, whatever moves behind the vertex.
     */
    void start_step(const std::vector<SlidingContact<dim>> &contacts, const FluidMesh<dim> &mesh,
                    const ParticleCloud<dim> &cloud, const FluidLaw &law, const double time_step,
                    const NodePartition &partition);

    /// Add forces and tangents to @p system at the mean @p velocities (m/s) and the @p pressures (Pa) by local number.
    void assemble(const std::vector<Tensor<1, dim>> &velocities, const std::vector<double> &pressures,
                  BlockSystem<dim> &system) const;

    /// End an iteration: λ = P.
    void update(const std::vector<Tensor<1, dim>> &velocities, const std::vector<double> &pressures);

    /// Keep the multipliers with the particles of the region's mesh; what does not slide has none.
    void accept(const FluidMesh<dim> &mesh, ParticleCloud<dim> &cloud) const;

    bool empty() const
    {
      return contacts.empty();
    }

  private:
    struct Contact
    {
      SlidingContact<dim> at; ///< with the vertex of the region's mesh
      unsigned int node;      ///< local number
      Tensor<1, dim> multiplier;
    };

    std::vector<Contact> contacts; ///< of the nodes that this rank knows
  };
} // namespace Lahar

#endif
