// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_thixotropy_h
#define lahar_material_thixotropy_h

#include <lahar/utilities/parameters.h>

namespace Lahar
{
  /**
   * How a yield stress builds up at rest and breaks down in flow (Roussel, Cem. Concr. Res. 36 (2006) 1797): it is
   * (1 + λ) τ_y, and the structure parameter λ ≥ 0 of a particle of the fluid follows
   *
   *   dλ/dt = 1/T − α λ γ̇,
   *
   * T the flocculation time, α ≥ 0 the deflocculation parameter. By default T is infinite and λ zero: no thixotropy.
   */
  class Thixotropy
  {
  public:
    /// Declare `Flocculation time`, `Deflocculation parameter` and `Initial structure`.
    static void declare_parameters(Parameters &prm);

    /// @param has_yield_stress whether there is something to build up. @throws InputError
    void parse_parameters(const Parameters &prm, const bool has_yield_stress);

    /// Whether λ is ever above zero.
    bool is_there() const
    {
      return rate > 0. || initial > 0.;
    }

    /// λ of fluid that is new: at the start, and where it comes in.
    double initial_structure() const
    {
      return initial;
    }

    /**
     * λ after a time in which the strain rate is constant, exactly:
     *
     *   λ e^{−s} + (Δt/T) (1 − e^{−s})/s,   s = α γ̇ Δt.
     *
     * It lies between λ and its limit 1/(T α γ̇), however long the time is.
     */
    double after(const double structure, const double strain_rate, const double time_step) const;

  private:
    double rate = 0., alpha = 0., initial = 0.; ///< 1/T in 1/s, α, λ at the start
  };
} // namespace Lahar

#endif
