// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_solid_assembler_h
#define lahar_assembly_solid_assembler_h

#include <lahar/linear/block_system.h>
#include <lahar/solid/solids.h>

namespace Lahar
{
  /// How the solids' unknowns follow the velocities at the end of a step.
  struct SolidFactors
  {
    double position     = 0.; ///< ∂x/∂v, s
    double acceleration = 0.; ///< ∂a/∂v, 1/s
  };

  /// What acts on the solids beside the fluid.
  template <int dim>
  struct SolidLoads
  {
    const Tensor<1, dim> &gravity;                      ///< m/s²
    const std::vector<Tensor<1, dim>> &external_forces; ///< by node, N, or empty
  };

  /**
   * Assembles the solids' momentum balance in the configuration at the end of the step,
   *
   *   R_I = ∫ N_I ρ a + ∫ σ ∇N_I − ∫ N_I ρ g − ∫_Γ N_I T,
   *
   * with the consistent mass matrix (∫ N_I N_J ρ does not change with time) and its whole derivative with respect to
   * the velocities: s = ∂x/∂v, g_J = ∇N_J, A = ∂σ/∂(∇δu),
   *
   *   K_Ia,Jb = ∂a/∂v δ_ab ∫ N_I N_J ρ + s ∫ A_akbl g_Ik g_Jl + s ∫ σ_ak (g_Ik g_Jb − g_Jk g_Ib).
   */
  template <int dim>
  class SolidAssembler
  {
  public:
    /**
     * Add the solids to @p system. @param nodes the system's number of each node.
     * @return whether all cells have positive volume; if not, the system is incomplete.
     */
    bool assemble(const Solids<dim> &solids, const SolidState<dim> &state, const SolidFactors &factors,
                  const SolidLoads<dim> &loads, const IndexVector<SolidNode, RegionNode> &nodes,
                  BlockSystem<dim> &system) const;

    /// Set the stress of @p state from its positions and from the solids' state at the start of the step.
    void update_stress(const Solids<dim> &solids, SolidState<dim> &state) const;
  };
} // namespace Lahar

#endif
