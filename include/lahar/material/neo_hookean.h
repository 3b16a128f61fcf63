// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_neo_hookean_h
#define lahar_material_neo_hookean_h

#include <lahar/material/solid_law.h>

namespace Lahar
{
  /**
   * Compressible neo-Hookean solid with the energy per undeformed volume (Simo & Hughes, Computational Inelasticity,
   * 1998, Section 9.2)
   *
   *   Ψ = G/2 (J^{−2/3} tr b − 3) + κ/2 ((J² − 1)/2 − ln J),   b = F Fᵀ, J = det F,
   *   σ = G J^{−5/3} dev b + κ/2 (J − 1/J) 1.
   *
   * The stress does not depend on the path.
   */
  class NeoHookean : public SolidLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    Response evaluate(const Tensor<2, 3> &old_F, const Tensor<2, 3> &F, const Stress &old_stress,
                      const unsigned int dim) const override;

    double energy_density(const Tensor<2, 3> &F, const Stress &stress) const override;
  };
} // namespace Lahar

#endif
