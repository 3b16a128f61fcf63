// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_regularized_power_h
#define lahar_material_regularized_power_h

#include <lahar/material/fluid_law.h>

namespace Lahar
{
  /**
   * A viscosity that is a power of the strain rate, finite at rest:
   *
   *   μ(γ̇) = K (γ̇² + ε²)^(a/2),   μ'(γ̇) = K a γ̇ (γ̇² + ε²)^(a/2 − 1).
   *
   * With a = n − 1 and n > 0 the stress μ γ̇ grows with γ̇,
   * d(μ γ̇)/dγ̇ = K (γ̇² + ε²)^((n−3)/2) (n γ̇² + ε²), and differs from K γ̇^n by less than K ε^n for n < 1. It is the
   * viscosity, not the stress, that n < 1 makes singular at rest: ε is no yield stress. With a = 0 it is K exactly.
   */
  class RegularizedPower
  {
  public:
    RegularizedPower() = default;

    /// @param factor K, Pa s^(a+1). @param exponent a. @param smallest_rate ε > 0, 1/s.
    RegularizedPower(const double factor, const double exponent, const double smallest_rate)
      : factor(factor)
      , exponent(exponent)
      , smallest_rate(smallest_rate)
    {}

    FluidLaw::Value operator()(const double strain_rate) const;

    /// Declare `Smallest strain rate`, ε.
    static void declare_smallest_rate(Parameters &prm);

    /// Read it. @throws InputError
    static double parse_smallest_rate(const Parameters &prm);

  private:
    double factor = 0., exponent = 0., smallest_rate = 1.;
  };
} // namespace Lahar

#endif
