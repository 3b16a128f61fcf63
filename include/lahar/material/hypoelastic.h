// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_hypoelastic_h
#define lahar_material_hypoelastic_h

#include <lahar/material/solid_law.h>

namespace Lahar
{
  /**
   * Hypoelastic solid: the Jaumann rate of the Cauchy stress is c : d, c = κ 1⊗1 + 2 G I'.
   *
   * Integrated over a step in the way of Hughes & Winget (Int. J. Numer. Meth. Engng. 15 (1980) 1862–1867): with the
   * displacement's gradient in the configuration half-way, H = ∂Δu/∂x_{n+1/2} = D + W (symmetric and skew parts),
   *
   *   σ = R σ_n Rᵀ + c : D,   R = (1 − W/2)⁻¹ (1 + W/2).
   *
   * A rigid rotation makes D = 0 and R that rotation, whatever its size. The stress depends on the path;
   * energy_density() is σ : c⁻¹ : σ/2, exact for small strains.
   */
  class Hypoelastic : public SolidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    Response evaluate(const Tensor<2, 3> &old_F, const Tensor<2, 3> &F, const Stress &old_stress,
                      const unsigned int dim) const override;

    double energy_density(const Tensor<2, 3> &F, const Stress &stress) const override;
  };
} // namespace Lahar

#endif
