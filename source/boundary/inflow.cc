// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/inflow.h>
#include <lahar/utilities/factory.h>

#include <array>
#include <cmath>
#include <sstream>

namespace Lahar
{
  void Inflow::declare_parameters(Parameters &prm)
  {
    prm.declare_list(
      "Velocity", "", ';',
      "Velocity of the fluid that comes in, at right angles to the boundary, in m/s: a function "
      "of the time t, zero or above. It is multiplied by 'Profile'. Just one of 'Velocity', "
      "'Discharge' and 'Discharge table' is given.");
    prm.declare_list("Discharge", "", ';',
                     "Volume that comes in per time, in m^3/s (in the plane m^2/s): a function of t, zero or "
                     "above. 'Profile' is scaled so that the discharge is just this.");
    prm.declare_file("Discharge table",
                     "The discharge as a table: lines 't, Q' in s and m^3/s (in the plane m^2/s), linear in "
                     "between and constant before and after; its name is relative to the parameter file that "
                     "gives it.");
    prm.declare_list(
      "Profile", "1", ';',
      "How the velocity is spread over the boundary: a function of the coordinates x, y, z, zero or "
      "above. 'y * (0.2 - y)' is the parabola between walls 0.2 m apart.");
    prm.declare_text("Fluid", "", "Name of the fluid that comes in; empty: the first one.");
  }



  void Inflow::parse_parameters(Parameters &prm)
  {
    section             = prm.path("");
    unsigned int n_ways = 0;
    for (const std::string entry : {"Velocity", "Discharge", "Discharge table"})
      if (!prm.get(entry).empty())
      {
        ++n_ways;
        source = entry;
      }
    if (n_ways != 1)
      prm.throw_wrong_value("Velocity",
                            "just one of 'Velocity', 'Discharge' and 'Discharge table', of which " +
                              std::to_string(n_ways) + " are given");
    of_discharge = source != "Velocity";
    has_table    = source == "Discharge table";
    if (has_table)
      table = TimeTable(prm.get(source), {"discharge"});
    else
      function = TimeFunctions(prm, source, 1);
    shape_text = prm.get("Profile");
    shape      = std::make_shared<FunctionParser<3>>(1);
    try
    {
      shape->initialize("x,y,z", shape_text, {{"pi", numbers::PI}}, false);
      shape->value(Point<3>());
    }
    catch (const std::exception &)
    {
      prm.throw_wrong_value("Profile", "one function of the coordinates x, y, z");
    }
    fluid_name = prm.get("Fluid");
  }



  double Inflow::mean(const double start, const double length) const
  {
    double value = 0.;
    if (has_table)
      value = table.mean(start, length)[0];
    else if (length == 0.)
      value = function(start)[0];
    else // three points of Gauss
    {
      const std::array<double, 3> places  = {{0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)}},
                                  weights = {{5. / 18., 8. / 18., 5. / 18.}};
      for (unsigned int q = 0; q < places.size(); ++q)
        value += weights[q] * function(start + places[q] * length)[0];
    }
    if (!(value >= 0.))
    {
      std::ostringstream message;
      message << "parameter '" << path(source) << "' gives " << value << " at " << start
              << " s. Allowed: inflow that is zero or above";
      throw RunError(message.str());
    }
    return value;
  }



  double Inflow::profile(const Point<3> &point) const
  {
    const double value = shape->value(point);
    if (!(value >= 0.) || !std::isfinite(value))
    {
      std::ostringstream message;
      message << "Parameter '" << path("Profile") << "' is '" << shape_text << "', which is " << value
              << " at (" << point << ") m. Allowed: finite values, zero or above, all over the boundary.";
      throw InputError(message.str());
    }
    return value;
  }



  void Inflow::check_times(const double from, const double to) const
  {
    constexpr unsigned int n_times = 1000;
    try
    {
      for (unsigned int i = 0; i <= n_times; ++i)
        mean(from + i * (to - from) / n_times, 0.);
    }
    catch (const RunError &error)
    {
      throw InputError("Inflow: " + std::string(error.what()) + ".");
    }
  }



  static const Factory<SurfaceLaw>::Registration<Inflow> inflow("inflow",
                                                                "Fluid comes in through the surface.");
} // namespace Lahar
