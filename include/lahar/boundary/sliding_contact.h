// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_sliding_contact_h
#define lahar_boundary_sliding_contact_h

#include <lahar/boundary/surface_law.h>
#include <lahar/boundary/wall_step.h>
#include <lahar/remeshing/fluid_mesh.h>

#include <vector>

namespace Lahar
{
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
   * With s the tangential part of the vertex's velocity relative to the boundary, the traction of a SurfaceLaw is
   * that of an augmented Lagrangian,
   *
   *   t = −[β s + τ_c P],   P = Y/max(τ_c, |Y|),   Y = τ_c λ + k s,
   *
   * whose multiplier λ, |λ| ≤ 1, is set to P after each iteration: then P = s/|s| where the vertex slides, and s = 0 where
   * |P| < 1, whatever k > 0 is; k says how fast. λ is kept by the particle from step to step. The normal stress is
   * N = max(−p, 0), p the vertex's pressure.
   * The tangent of P is exact. (Semismooth Newton for Tresca's and Coulomb's friction: Hüeber, Stadler & Wohlmuth, SIAM J.
   * Sci. Comput. 30 (2008) 572–596.)
   */
  template <int dim>
  struct SlidingContact
  {
    unsigned int vertex   = 0;
    const SurfaceLaw *law = nullptr;
    double area           = 0.; ///< A, m² (m in the plane)
    Tensor<1, dim> normal;
    Tensor<1, dim> wall_velocity; ///< mean of the step, m/s
    double stiffness = 0.;        ///< k, Pa s/m

    /// At the mean @p velocity (m/s) and @p pressure (Pa, positive in tension) with @p multiplier for λ.
    SlidingForce<dim> force(const Tensor<1, dim> &velocity, const double pressure,
                            const Tensor<1, dim> &multiplier) const;

    /**
     * All contacts of a mesh at the start of a step, by ascending vertices.
     * Their stiffness is not set. @param laws by boundary.
     */
    static std::vector<SlidingContact> find(const FluidMesh<dim> &mesh, const ParticleCloud<dim> &cloud,
                                            const WallStep<dim> &step,
                                            const std::vector<const SurfaceLaw *> &laws);
  };
} // namespace Lahar

#endif
