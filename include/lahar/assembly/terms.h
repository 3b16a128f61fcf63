// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_terms_h
#define lahar_assembly_terms_h

#include <lahar/assembly/assemble_stress.h>
#include <lahar/assembly/face_pressure.h>
#include <lahar/assembly/fluid_cell.h>

namespace Lahar
{
  /// How the viscosity enters the Jacobian.
  enum class ViscosityLinearization
  {
    picard,     ///< μ_eff is taken as constant
    newton,     ///< consistent derivative
    primal_dual ///< consistent derivative of the viscous part, primal–dual derivative of the plastic part
  };

  /**
   * Inertia: R_I += ∫ N_I ρ a, with the consistent mass matrix.
   */
  template <int dim>
  struct Inertia
  {
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;
  };

  /**
   * Weight: R_I −= ∫ N_I ρ g.
   */
  template <int dim>
  struct BodyForce
  {
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;
  };

  /**
   * Viscous and plastic stress: R_I += ∫ ∇N_I·τ, τ = 2 μ_eff d'; where the yield stress is exact the viscous part alone,
   * τ = 2 μ d' (the other one is ExactPlasticStress).
   *
   * Where the law depends on the pressure, ∂R_I/∂p_J = −∫ (1/(dim+1)) (∂μ_eff/∂P) ∇N_I·2d' for p̄ < 0, zero in tension and
   * with Picard: the system's Q is then not that of the mass equation, see BlockSystem.
   *
   * The rest of the Jacobian's material part is 2 μ_t I' + c (A ⊗ B + B ⊗ A). Picard: c = 0. Newton: A = B = d',
   * c = 2 μ_eff'/γ̇.
   * Primal–dual (De los Reyes & González Andrade 2010; Rudi, Shih & Stadler, arXiv 2003.11115): for the plastic part
   * A = d', B = Λ̂ and c = −τ_y ψ'/(γ̇ ψ) with ψ = 1/f, Λ̂ = Λ/max(1, |Λ|), |Λ|² = Λ:Λ/2. With Λ = 2 f d' it equals
   * Newton. Where |Λ − 2 f d'| = δ > 0, c is multiplied by 1 − min(0.3, 3 δ): along d' little but this derivative
   * balances the secant stiffness of a yielding cell, and without the rest the iteration would overshoot.
   */
  template <int dim>
  class ViscousStress
  {
  public:
    /// @param plastic_weight factor of the plastic part's derivative, below one to stiffen the Jacobian.
    explicit ViscousStress(const ViscosityLinearization linearization, const double plastic_weight = 1.)
      : linearization(linearization)
      , plastic_weight(plastic_weight)
    {}

    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;

    /// τ and its derivative with respect to d' where the yield stress is exact, and the viscous part does not depend on the
    /// pressure.
    CellStress<dim> viscous_part(const FluidCell<dim> &cell) const;

  private:
    ViscosityLinearization linearization;
    double plastic_weight;
  };

  /**
   * Pressure and incompressibility: R_I += ∫ ∇N_I p in the momentum rows; in the mass rows
   * R_I += ∫ N_I (1/κ) (p − p_n)/Δt − (V − V_n)/((dim+1) Δt): the change of the cell's volume in the step, which is exact
   * whatever the velocities at its start are.
   */
  template <int dim>
  struct PressureDivergence
  {
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;
  };

  /**
   * The same for a flat cell, see Slivers: volume V and area vectors V ∇N_I are those of its corners at the end of the
   * step, whatever the sign of V is, while the cell keeps the shape that it has at the start for all else. The derivative
   * of the area vectors is left out of the Jacobian.
   */
  template <int dim>
  struct FlatPressureDivergence
  {
    /// @param cell in the shape of the start of the step. @param corners at the end, m.
    void assemble(const FluidCell<dim> &cell, const std::array<Point<dim>, dim + 1> &corners,
                  CellSystem<dim> &system) const;
  };

  /**
   * FIC stabilisation inside the fluid (Oñate, Franci & Carbonell 2014):
   * R_I += ∫ τ_s ∇N_I·(∇p + ρ g) + ∫ τ_s (ρ/κ) N_I (p − p_n − ṗ_n Δt)/Δt².
   */
  template <int dim>
  struct FICInterior
  {
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;
  };

  /**
   * FIC stabilisation on the free surface, where t = 0:
   * R_I += ∫_Γ (2 τ_s/h_n) N_I p − ∫_Γ τ_s N_I (ρ a·n − (2/h_n) 2 μ n·d'·n), h_n the cell's height over the face.
   * μ is the viscosity that enters τ_s too, constant during a step.
   */
  template <int dim>
  struct FICFreeSurface
  {
    /// @param opposite the cell's node that the face does not have.
    void assemble(const FluidCell<dim> &cell, const unsigned int opposite, CellSystem<dim> &system) const;
  };

  /**
   * Traction −p n on a face, p linear on it between its corners: R_I += ∫_Γ N_I p n. p and n are those of the face where
   * it is at the end of the step.
   */
  template <int dim>
  struct PrescribedPressure
  {
    /// @param corners of the cell, m. @param opposite the cell's node that the face does not have.
    void assemble(const FluidCell<dim> &cell, const std::array<Point<dim>, dim + 1> &corners,
                  const unsigned int opposite, const FacePressure<dim> &pressure,
                  CellSystem<dim> &system) const;
  };

  /**
   * Residual-based stabilisation (PSPG): R_I += ∫ τ_s ∇N_I·(∇p + ρ g − ρ a − π), π see ResidualProjection.
   *
   * Consistent without boundary terms; since the shape functions sum to one, the rows sum to ∫ div v = 0: the scheme
   * keeps the fluid's volume to solver tolerance.
   */
  template <int dim>
  struct ResidualStabilization
  {
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;
  };
} // namespace Lahar

#endif
