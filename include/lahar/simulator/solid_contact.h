// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_solid_contact_h
#define lahar_simulator_solid_contact_h

#include <lahar/boundary/solid_touch.h>
#include <lahar/linear/block_system.h>
#include <lahar/linear/numbering.h>
#include <lahar/material/materials.h>
#include <lahar/simulator/fluid_step.h>
#include <lahar/simulator/solid_step.h>

#include <vector>

namespace Lahar
{
  /**
   * Fluid along slick solids during one time step: a vertex of the fluid stays on the plane of its facet, whose corners are
   * nodes of a solid. With the positions at the end of the step, n the facet's normal there, N_i the corners' shares of the
   * vertex's foot and d the distance from the plane that the vertex had at the start,
   *
   *   g = [n·(x − Σ N_i x_i) − d]/Δt = 0.
   *
   * The force −f n on the vertex and the forces N_i f n on the corners are those of an augmented Lagrangian, f = λ + β g:
   * momentum and its moment pass from the fluid to the solid whole. λ is the force of the last step at first and becomes f
   * after every iteration, so that g falls with each of them by the ratio of what resists the vertex and the facet to β. Since n and
   * N_i are those of the end, ∂g/∂v is n for the vertex and −N_i n for the corners, exact where g = 0.
   */
  template <int dim>
  class SolidContact
  {
  public:
    /// Begin a step of length @p time_step (s). β is a multiple of h^(dim−1) (ρ h/Δt + μ/h), h the particle's spacing and μ
    /// the viscous part at the strain rate 1/Δt.
    void start_step(const std::vector<SolidTouch<dim>> &touches, const FluidMesh<dim> &mesh,
                    const ParticleCloud<dim> &cloud, const Materials &materials, const double time_step);

    /// The contacts as BlockSystem wants them. @param nodes the region's node of each node of the solids.
    std::vector<unsigned int> cells(const IndexVector<SolidNode, RegionNode> &nodes) const;

    /// Go on with those that the system has. Collective.
    void number(const BlockSystem<dim> &system, const Numbering &numbering);

    /// Whether any rank has any.
    bool any() const
    {
      return is_any;
    }

    /// Let the fluid's velocities close the gaps that the solids' present velocities leave, where nothing prescribes them.
    void close_gaps(const Numbering &numbering,
                    const IndexVector<LocalNode, NodeConstraint<dim>> &constraints,
                    IndexVector<LocalNode, Tensor<1, dim>> &velocities) const;

    /// Normals, shares and gaps at the present end of the step.
    void move(const FluidStep<dim> &fluid, const SolidStep<dim> &solid);

    /// Add forces and tangents.
    void assemble(BlockSystem<dim> &system) const;

    /// End an iteration: λ becomes f.
    void iterate();

    /// Number of the system's contacts.
    unsigned int n_contacts() const
    {
      return known.size();
    }

    const SolidTouch<dim> &touch(const unsigned int k) const
    {
      return known[k].touch;
    }

    /// f n, what the vertex exerts on the solid, N: with the gaps that an iteration ends with it is the force that solves
    /// the iteration's system.
    Tensor<1, dim> normal_force(const unsigned int k) const
    {
      return (known[k].multiplier + known[k].stiffness * known[k].gap) * known[k].normal;
    }

    /// Number of the system's contact of a vertex of the region's mesh with a facet; numbers::invalid_unsigned_int if it
    /// has none.
    unsigned int find(const unsigned int vertex, const unsigned int facet) const;

    /// Weights of the nodes of one of the system's contacts in the velocity of the vertex relative to the facet.
    std::array<double, dim + 1> weights(const unsigned int k) const;

    /// Mean velocity in the step of the facet's point below the vertex, m/s.
    const Tensor<1, dim> &surface_velocity(const unsigned int k) const
    {
      return known[k].velocity;
    }

    const Tensor<1, dim> &normal(const unsigned int k) const
    {
      return known[k].normal;
    }

  private:
    struct Contact
    {
      SolidTouch<dim> touch;
      Vertex vertex;
      double stiffness  = 0.; ///< β, N s/m
      double multiplier = 0.; ///< λ, N
      double gap        = 0.; ///< g, m/s
      Tensor<1, dim> normal, velocity;
      std::array<double, dim> shares = {};
    };

    std::vector<Contact> all, known; ///< of the region; of the system, by its number
    double time_step = 0.;
    bool is_any      = false;
  };
} // namespace Lahar

#endif
