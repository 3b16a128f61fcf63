// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_sliding_contact_h
#define lahar_boundary_sliding_contact_h

#include <lahar/boundary/surface_law.h>
#include <lahar/boundary/wall_step.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <vector>

namespace Lahar
{
  /// What a contact knows besides velocity and pressure.
  template <int dim>
  struct SlidingState
  {
    Tensor<1, dim> multiplier;    ///< λ
    double excess_stress = 0.;    ///< e, Pa
    bool held            = false; ///< whether the vertex is held, whatever it takes
    Tensor<1, dim> direction;     ///< P of the iteration before if the vertex slid, else zero
  };

  /// Force of a vertex on a surface along which it slides, and its derivatives.
  template <int dim>
  struct SlidingForce
  {
    Tensor<1, dim> value;       ///< −A t, N
    Tensor<2, dim> by_velocity; ///< N s/m
    Tensor<1, dim> by_pressure; ///< N/Pa
    Tensor<1, dim> multiplier;  ///< P
  };

  /**
   * A vertex that slides along a boundary that resists, with its share A of the boundary: that of the faces whose corners
   * all touch the boundary, divided evenly among their corners.
   *
   * With s the tangential part of the vertex's velocity relative to the boundary, the traction of a SurfaceLaw is that of
   * an augmented Lagrangian,
   *
   *   t = −[β s + τ_c P],   P = Y/max(τ_c, |Y|),   Y = τ_c λ + k s,
   *
   * whose multiplier λ, |λ| ≤ 1, is constant in a step and P of its end in the next one: so P = s/|s| where the vertex
   * slides, and where it sticks s falls to zero within few steps, the faster the larger k is. The particle keeps λ. In a
   * step P is the derivative of a convex function of s, and its tangent is exact. (Semismooth Newton for Tresca's and
   * Coulomb's friction: Hüeber, Stadler & Wohlmuth, SIAM J. Sci. Comput. 30 (2008) 572–596.) Sliding that turns round
   * within an iteration has passed over sticking: in the next one the vertex is held, P = Y/τ_c without a limit.
   *
   * The normal stress N is the reaction of the vertex over A. It follows the pressure, N = max(e − p, 0), and e comes
   * halfway to N + p in each of the first iterations of a step, so that friction is τ_c of the whole reaction, viscous
   * stress included. Later on it stays: where friction turns its own normal stress round it would go to and fro.
   * Of N the grains bear what is above the pressure p_w of the water in their pores: τ_c is that of max(N − p_w, 0).
   */
  template <int dim>
  struct SlidingContact
  {
    unsigned int vertex   = 0;
    const SurfaceLaw *law = nullptr;
    double area           = 0.;   ///< A, m² (m in the plane)
    Tensor<1, dim> normal;        ///< into the fluid
    Tensor<1, dim> wall_velocity; ///< mean of the step, m/s
    double stiffness     = 0.;    ///< k, Pa s/m
    unsigned int facet   = 0;     ///< of the walls of the step
    double pore_pressure = 0.;    ///< p_w at the start of the step, Pa

    /// At the mean @p velocity (m/s) and @p pressure (Pa, positive in tension).
    SlidingForce<dim> force(const Tensor<1, dim> &velocity, const double pressure,
                            const SlidingState<dim> &state) const;

    /// What @p state becomes after an iteration that ended with this velocity and pressure, and with the boundary's
    /// @p reaction on the vertex, N, of the last assembly: that N at the present pressure; to let it change with the
    /// pressure's increment overshoots in stiff fluids. λ stays, and e unless it @p follows the reaction.
    void iterate(const Tensor<1, dim> &velocity, const double pressure, const Tensor<1, dim> &reaction,
                 const bool follows, SlidingState<dim> &state) const;

    /**
     * All contacts of a mesh at the start of a step, by ascending vertices.
     * Their stiffness and pore pressure are not set. @param laws by boundary.
     */
    static std::vector<SlidingContact> find(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                            const WallStep<dim> &step,
                                            const std::vector<const SurfaceLaw *> &laws);
  };
} // namespace Lahar

#endif
