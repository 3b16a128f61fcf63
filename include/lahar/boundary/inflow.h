// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_inflow_h
#define lahar_boundary_inflow_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/time_functions.h>
#include <lahar/utilities/time_table.h>

#include <memory>

namespace Lahar
{
  /**
   * How much fluid comes in through a surface, at right angles to it: the velocity
   *
   *   v = U(t) φ(x)   or   v = Q(t) φ(x) / ∫ φ,
   *
   * φ the `Profile`. What moves the fluid is a matter of Inlets.
   */
  class Inflow : public SurfaceLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// @throws InputError, also unless just one of 'Velocity', 'Discharge' and 'Discharge table' is there.
    void parse_parameters(Parameters &prm) override;

    bool lands() const override
    {
      return false;
    }

    /// Whether mean() is Q and not U.
    bool is_discharge() const
    {
      return of_discharge;
    }

    /// The mean of U (m/s) or Q (m³/s, in the plane m²/s) in the @p length s that begin at @p start. @throws RunError
    /// unless it is finite and not negative.
    double mean(const double start, const double length) const;

    /// φ, not negative. @throws InputError otherwise.
    double profile(const Point<3> &point) const;

    /// @throws InputError if the inflow is negative or not finite between two times (s), as seen at a thousand of them.
    void check_times(const double from, const double to) const;

    /// The name of the fluid that comes in; empty for the first one.
    const std::string &fluid() const
    {
      return fluid_name;
    }

    /// The path of an entry, for messages.
    std::string path(const std::string &entry) const
    {
      return section + entry;
    }

  private:
    bool of_discharge = false, has_table = false;
    TimeFunctions function;
    TimeTable table;
    std::shared_ptr<FunctionParser<3>> shape;
    std::string section, source, shape_text, fluid_name; ///< source: the entry that says how much
  };
} // namespace Lahar

#endif
