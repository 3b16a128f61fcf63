// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/material/thixotropy.h>

#include <cmath>

namespace Lahar
{
  void Thixotropy::declare_parameters(Parameters &prm)
  {
    prm.declare_text(
      "Flocculation time", "infinite",
      "Time T in s, above zero, in which the yield stress of fluid at rest grows by that of fluid without "
      "structure, or 'infinite': it is (1 + λ) τ0 with dλ/dt = 1/T − α λ γ̇.");
    prm.declare_positive("Deflocculation parameter", "0.01",
                         "Parameter α, zero or above: flow breaks structure at the rate α γ̇.");
    prm.declare_positive("Initial structure", "0",
                         "Structure parameter λ, zero or above, at the start and of fluid that comes in.");
  }



  void Thixotropy::parse_parameters(const Parameters &prm, const bool has_yield_stress)
  {
    const std::optional<double> time = prm.get_positive_or("Flocculation time", "infinite");
    rate                             = time ? 1. / *time : 0.;
    alpha                            = prm.get_positive("Deflocculation parameter", true);
    initial                          = prm.get_positive("Initial structure", true);
    if (has_yield_stress)
      return;
    if (rate > 0.)
      prm.throw_wrong_value("Flocculation time", "'infinite' for a fluid whose yield stress is zero");
    if (initial > 0.)
      prm.throw_wrong_value("Initial structure", "0 for a fluid whose yield stress is zero");
  }



  double Thixotropy::after(const double structure, const double strain_rate, const double time_step) const
  {
    const double s = alpha * strain_rate * time_step;
    // (1 − e^{−s})/s, whose series is exact to rounding below 1e-8.
    const double mean = s < 1e-8 ? 1. - 0.5 * s : -std::expm1(-s) / s;
    return structure * std::exp(-s) + rate * time_step * mean;
  }
} // namespace Lahar
