// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_fluid_assembler_h
#define lahar_assembly_fluid_assembler_h

#include <lahar/assembly/fluid_state.h>
#include <lahar/assembly/stabilization.h>
#include <lahar/assembly/terms.h>
#include <lahar/linear/block_system.h>
#include <lahar/material/materials.h>
#include <lahar/remeshing/fluid_mesh.h>
#include <lahar/utilities/parameters.h>

#include <memory>

namespace Lahar
{
  /**
   * Assembles the fluid's residual and Jacobian: the sum over the cells of inertia, weight, viscous stress, pressure and
   * incompressibility, and of the chosen Stabilization, which has terms of the faces on the free surface, too.
   */
  template <int dim>
  class FluidAssembler
  {
  public:
    /// What the Jacobian contains.
    struct Linearization
    {
      ViscosityLinearization viscosity = ViscosityLinearization::primal_dual;
      double plastic_weight            = 1.; ///< factor of the plastic part's derivative
      /// The dependence of the geometry on the velocity, but of cells that lose much of their volume in the step.
      bool motion = true;
    };

    static void declare_parameters(Parameters &prm);
    void parse_parameters(Parameters &prm);

    /**
     * Set τ_s of all cells for a step, and π of its start, see ResidualProjection, for each fluid from its own cells: q
     * jumps where the density does. No cell is left out.
     *
     *   τ(μ) = (8 μ/h² + 2 ρ/Δt)^{-1},   τ_s = min(τ(min(μ_eff, μ_limit)), max(τ(μ_eff), 4 |v|/(ρ|g|))),
     *
     * h the edge of the equilateral simplex of the cell's volume, |v| the largest speed of its corners, μ_limit a
     * parameter, all at the start of the step. τ_s |q − π| is the velocity at which the stabilisation lets fluid pass
     * through its own pressure gradient, and q − π a few hundredths of ρ g: so a plug that moves has a τ_s that keeps its
     * pressure smooth, one that stands leaks by less than it creeps.
     *
     * Where the yield stress is exact τ_s = τ(min(μ_eff, μ_limit)) everywhere, and in cells that stand (state.stands) π is
     * the cell's own ∇p + ρ g of the start of the step: pressures that carry fluid at rest stay as they are, and nothing
     * drives it.
     */
    void set_stabilization(const FluidMesh<dim> &mesh, const Materials &materials,
                           FluidState<dim> &state) const;

    /// Whether the stabilisation has a projection, see ResidualProjection.
    bool projects_residual() const
    {
      return stabilization->projects_residual();
    }

    /// Set Λ = 2 f e' of all cells from the present velocities, see FluidCell::plastic_rate().
    void start_plastic_dual(const FluidMesh<dim> &mesh, const Materials &materials,
                            FluidState<dim> &state) const;

    /**
     * How Λ follows the mean velocities when they change by α times @p increment (by vertex) from the present state:
     * Λ(α) = base + α slope, base = 2 e'/ψ, slope = [2 δd' − ψ' (2 e':δd'/ε̇) Λ̂]/ψ, see FluidCell::plastic_rate().
     */
    void predict_plastic_dual(const FluidMesh<dim> &mesh, const Materials &materials,
                              const FluidState<dim> &state, const std::vector<Tensor<1, dim>> &increment,
                              std::vector<SymmetricTensor<2, dim>> &base,
                              std::vector<SymmetricTensor<2, dim>> &slope) const;

    /**
     * Of a yield stress that is exact: Λ_k becomes Λ_{k+1} = P(X_k), X_k = Λ_k + 2 r d' of the present velocities, see
     * ExactPlasticStress.
     * @return Σ V τ0 [P(X_{k+1}) − P(X_k)]:δL over the @p counted cells, by which the work of the residual along
     * @p increment of the mean velocities (by vertex) grows, W.
     */
    double update_multipliers(const FluidMesh<dim> &mesh, const Materials &materials, FluidState<dim> &state,
                              const std::vector<Tensor<1, dim>> &increment,
                              const std::vector<bool> &counted) const;

    /**
     * G = τ0 Σ V (γ̇ − Λ:d') ≥ 0 with Λ = 2 f e', and E = ∫ ρ (∂a/∂v) |v|² + ∫ μ γ̇², sums over the @p counted cells, in W
     * (2D: W/m). In equilibrium G bounds the error that is left of the law without regularisation, in the norm in which E
     * is the size of the velocities themselves: from any velocity to the right one, ∫ ρ (∂a/∂v) |δv|² + 2 ∫ μ δd':δd' ≤ G,
     * where the geometry stays and without stabilisation.
     */
    struct YieldGap
    {
      double gap    = 0.;
      double energy = 0.;
    };
    YieldGap yield_gap(const FluidMesh<dim> &mesh, const Materials &materials, const FluidState<dim> &state,
                       const std::vector<bool> &counted) const;

    /// Assemble; the cells of @p mesh are those that this rank adds to @p system, in its order. @return whether all
    /// cells have positive volume; if not, the system is incomplete. Of cells that are left out there is the diagonal
    /// alone, of inertia and stabilisation at the start of the step: what has no other cell keeps its values.
    bool assemble(const FluidMesh<dim> &mesh, const Materials &materials, const FluidState<dim> &state,
                  const Linearization &linearization, BlockSystem<dim> &system) const;

  private:
    static void leave_out(const FluidCell<dim> &cell, CellSystem<dim> &system);
    static FluidCell<dim> make_cell(const FluidMesh<dim> &mesh, const Materials &materials,
                                    const FluidState<dim> &state, const unsigned int c,
                                    const bool linearize_motion = false);

    std::unique_ptr<const Stabilization<dim>> stabilization;
    double viscosity_limit = 0.1;
  };
} // namespace Lahar

#endif
