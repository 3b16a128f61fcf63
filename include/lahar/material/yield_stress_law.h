// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_yield_stress_law_h
#define lahar_material_yield_stress_law_h

#include <lahar/material/fluid_law.h>

namespace Lahar
{
  /**
   * A fluid with a yield stress τ_y = τ0 + μ_s P, where μ_s is zero unless a derived class sets it. Of those without
   * friction `Yield` is one of
   *
   *   Papanastasiou  regularised (J. Rheol. 31 (1987) 385): the plastic part is τ0 f with
   *                  f(γ̇) = (1 − exp(−m γ̇)) / γ̇,   f(0) = m,   f'(0) = −m²/2,
   *   exact          not regularised: |τ| ≤ τ0 where γ̇ = 0. f is that of FluidLaw::augmentation().
   *
   * f γ̇ grows from 0 to 1, so that stress grows with γ̇ wherever that of the viscous part does. As m → ∞, f γ̇ → 1
   * wherever γ̇ > 0. A derived class gives the viscous part.
   */
  class YieldStressLaw : public FluidLaw
  {
  public:
    Value yield_stress(const double pressure) const override
    {
      return {tau_0 + friction * pressure, 0., friction};
    }

    Value plastic_part(const double strain_rate) const override;

    double augmentation() const override
    {
      return tau_0 > 0. ? r : 0.;
    }

    /// Whether there is an r, and it is left to choose_augmentation().
    bool chooses_augmentation() const
    {
      return chooses_r && augmentation() > 0.;
    }

    /**
     * Choose r for a step in which fluid of the length L = 2 V/A, half the depth of a block, has the inertia @p inertia =
     * ρ L²/Δt, Pa s: r τ0 = 400 (μ + ρ L²/Δt), μ at 1/s, to the next power of two of r in s. Nothing but the number of
     * iterations depends on r.
     */
    void choose_augmentation(const double inertia);

  protected:
    /// Declare `Yield stress`.
    static void declare_yield_stress(Parameters &prm);

    /// Declare `Regularization parameter`. @param unyielded viscosity of the unyielded fluid, for the documentation.
    static void declare_regularization(Parameters &prm, const std::string &unyielded);
    /// Declare `Yield` and the parameters of its choices, and those of Thixotropy.
    static void declare_yield(Parameters &prm, const std::string &unyielded);

    /// Read `Yield stress`. @throws InputError
    void parse_yield_stress(const Parameters &prm);

    /// Read what declare_regularization() declares. @throws InputError
    void parse_regularization(const Parameters &prm);
    /// Read what declare_yield() declares but for Thixotropy. @throws InputError
    void parse_yield(const Parameters &prm);
    /// Read Thixotropy, when #tau_0 is known. @throws InputError
    void parse_thixotropy(const Parameters &prm);

    double tau_0    = 0.; ///< Pa
    double friction = 0.; ///< μ_s

  private:
    double m       = 0.;
    double r       = 0.; ///< zero where the yield stress is regularised
    bool chooses_r = false;
  };
} // namespace Lahar

#endif
