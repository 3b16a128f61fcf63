// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/yield_stress_law.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    /// r τ0 over μ + ρ L²/Δt where r is chosen, L = 2 V/A: some 100 with the depth of a block for L.
    constexpr double best_ratio = 400.;
  } // namespace



  void YieldStressLaw::declare_yield_stress(Parameters &prm)
  {
    prm.declare_positive("Yield stress", "100",
                         "Yield stress τ0 in Pa, zero or above. With zero the fluid has none.");
  }



  void YieldStressLaw::declare_regularization(Parameters &prm, const std::string &unyielded)
  {
    prm.declare_positive(
      "Regularization parameter", "1000",
      "Papanastasiou's regularization parameter m in s, above zero. The unyielded fluid creeps with the "
      "viscosity " +
        unyielded + ".");
  }



  void YieldStressLaw::declare_yield(Parameters &prm, const std::string &unyielded)
  {
    declare_regularization(prm, unyielded);
    prm.declare_choice(
      "Yield", "Papanastasiou", "Papanastasiou|exact",
      "How the fluid yields: 'Papanastasiou' regularises the law by 'Regularization parameter', 'exact' does not: fluid "
      "below the yield stress is rigid, and stops.");
    prm.declare_text(
      "Augmentation parameter", "1000",
      "Parameter r in s, above zero, of the method of multipliers, where 'Yield' is 'exact'. The iteration depends on "
      "it, the result does not; a good value makes r τ0 10 to 100 times μ + ρ L²/Δt, L the depth of the fluid. 'auto' "
      "chooses it so in each step, for large masses that come to rest.");
    Thixotropy::declare_parameters(prm);
  }



  void YieldStressLaw::parse_yield_stress(const Parameters &prm)
  {
    tau_0 = prm.get_positive("Yield stress", true);
  }



  void YieldStressLaw::parse_regularization(const Parameters &prm)
  {
    m = prm.get_positive("Regularization parameter");
  }



  void YieldStressLaw::parse_yield(const Parameters &prm)
  {
    parse_regularization(prm);
    const std::optional<double> given = prm.get_positive_or("Augmentation parameter", "auto");
    chooses_r                         = !given;
    if (prm.get("Yield") == "exact")
      r = given.value_or(1.);
    else if (prm.get("Yield") != "Papanastasiou")
      prm.throw_wrong_value("Yield", "Papanastasiou|exact");
  }



  void YieldStressLaw::parse_thixotropy(const Parameters &prm)
  {
    structure_law.parse_parameters(prm, tau_0 > 0.);
  }



  void YieldStressLaw::choose_augmentation(const double inertia)
  {
    const double viscosity = viscous_part(1., 0.).value;
    r                      = std::exp2(std::round(std::log2(best_ratio * (viscosity + inertia) / tau_0)));
  }



  FluidLaw::Value YieldStressLaw::plastic_part(const double strain_rate) const
  {
    if (augmentation() > 0.)
      return r * strain_rate <= 1. ? Value{r, 0.}
                                   : Value{1. / strain_rate, -1. / (strain_rate * strain_rate)};

    // Below z = m γ̇ = 1e-4 the series is exact to rounding in f and better than 1e-8 in f', where the closed form of
    // f' cancels.
    const double z = m * strain_rate;
    if (z < 1e-4)
      return {m * (1. - z / 2. * (1. - z / 3.)), -m * m * (0.5 - z / 3. + z * z / 8.)};

    const double yielded = -std::expm1(-z);
    return {yielded / strain_rate, (m * std::exp(-z) - yielded / strain_rate) / strain_rate};
  }
} // namespace Lahar
