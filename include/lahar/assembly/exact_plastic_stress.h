// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_exact_plastic_stress_h
#define lahar_assembly_exact_plastic_stress_h

#include <lahar/assembly/terms.h>

namespace Lahar
{
  /**
   * The plastic stress of a yield stress that is not regularised, by the method of multipliers:
   *
   *   R_I += ∫ ∇N_I·τ0 P(X),   X = Λ_k + 2 r d',   P(X) = X/max(1, |X|),   |X|² = X:X/2.
   *
   * Λ_k is constant in an iteration of Newton's method and becomes P(X) after it (FluidAssembler::update_multipliers()).
   * Where Λ_k = P(X), X is parallel to d' where the fluid flows, and d' = 0 where |X| < 1: Bingham's law, whatever r > 0
   * is. It is the proximal point method on the dual of a convex problem, which converges for all r (R. T. Rockafellar,
   * SIAM J. Control Optim. 14 (1976) 877). τ0 P(X) = τ0 f(ε̇) 2 e' is Huber's law, f(ε̇) = min(r, 1/ε̇), at the shifted rate
   * e' = d' + Λ_k/(2 r), so that the tangents are those of ViscousStress: with a = 1 where |X| > 1 and 0 elsewhere, w the
   * weight and χ = max(1, |X|),
   *
   *   τ0 (2 r/χ) [I' − (a w/(4 χ)) (Λ̂ ⊗ X + X ⊗ Λ̂)],
   *
   * Λ̂ = X/|X| for Newton's method, a = 0 for Picard's.
   */
  template <int dim>
  class ExactPlasticStress
  {
  public:
    /// @param plastic_weight as for ViscousStress.
    explicit ExactPlasticStress(const ViscosityLinearization linearization, const double plastic_weight = 1.)
      : linearization(linearization)
      , plastic_weight(plastic_weight)
    {}

    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const;

    CellStress<dim> stress(const FluidCell<dim> &cell) const;

  private:
    /// B of the tangent 2 τ0 f I' + e' ⊗ B + B ⊗ e'.
    SymmetricTensor<2, dim> rank_one_part(const FluidCell<dim> &cell, const SymmetricTensor<2, dim> &rate,
                                          const double strain_rate, const FluidLaw::Value &f) const;

    ViscosityLinearization linearization;
    double plastic_weight;
  };
} // namespace Lahar

#endif
