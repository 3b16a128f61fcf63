// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_table_law_h
#define lahar_material_table_law_h

#include <lahar/material/yield_stress_law.h>
#include <lahar/utilities/monotone_curve.h>

namespace Lahar
{
  /**
   * A fluid whose stress is given at some strain rates γ̇_i, growing from row to row. The stress at rest, if the first
   * row is one of γ̇ = 0, is the yield stress τ0, regularised by Papanastasiou; without such a row there is none. The
   * viscous part is
   *
   *   μ(γ̇) = s(γ̇)/γ̇,   ln s a MonotoneCurve of ln γ̇ through ln(|τ|_i − τ0),
   *
   * and below the first γ̇_i > 0 it is constant. Above the last one the power law between the last two goes on. The rows
   * of a law of Newton, Bingham, Herschel–Bulkley (from γ̇ = 0) or of a power law give that law.
   */
  class TableLaw : public YieldStressLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    void parse_parameters(Parameters &prm) override;

    Value viscous_part(const double strain_rate, const double pressure) const override;

  private:
    MonotoneCurve logarithms;
    double first_rate = 1., first_viscosity = 0.;
  };
} // namespace Lahar

#endif
