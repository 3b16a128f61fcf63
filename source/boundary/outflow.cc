// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/outflow.h>
#include <lahar/utilities/factory.h>

#include <stdexcept>

namespace Lahar
{
  void Outflow::declare_parameters(Parameters &prm)
  {
    prm.declare_list(
      "Direction", "", ',',
      "A vector 'x, y' (in space 'x, y, z') to the side of the boundary where the fluid goes; only "
      "its side counts.");
    prm.declare_list(
      "Level", "", ';',
      "Level of the fluid behind the boundary, in m: a function of the time t, the last coordinate, y or in space z, of "
      "the points of the boundary where the pressure is zero. Below it the pressure is hydrostatic. Empty, as is "
      "'Level table': nothing is behind, the fluid falls freely.");
    prm.declare_file(
      "Level table",
      "The level as a table: lines 't, level' in s and m, linear in between and constant before and "
      "after; its name is relative to the parameter file that gives it.");
  }



  void Outflow::parse_parameters(Parameters &prm)
  {
    section = prm.path("");
    try
    {
      for (const std::string &text : split_list(prm.get("Direction"), ','))
        components.push_back(to_number(text));
    }
    catch (const std::invalid_argument &)
    {
      components.clear();
    }
    if (components.empty())
      prm.throw_wrong_value("Direction", "a vector, as '1, 0', to the side where the fluid goes");
    if (!prm.get("Level").empty())
    {
      if (!prm.get("Level table").empty())
        prm.throw_wrong_value("Level", "just one of 'Level' and 'Level table', of which both are given");
      source   = "Level";
      function = TimeFunctions(prm, source, 1);
    }
    else if (!prm.get("Level table").empty())
    {
      source = "Level table";
      table  = TimeTable(prm.get(source), {"level"});
    }
  }



  double Outflow::level(const double time) const
  {
    return source == "Level" ? function(time)[0] : table(time)[0];
  }



  void Outflow::check_times(const double from, const double to) const
  {
    constexpr unsigned int n_times = 1000;
    try
    {
      for (unsigned int i = 0; i <= n_times && has_level(); ++i)
        level(from + i * (to - from) / n_times);
    }
    catch (const RunError &error)
    {
      throw InputError("Outflow: " + std::string(error.what()) + ". Allowed: levels that are finite.");
    }
  }



  static const Factory<SurfaceLaw>::Registration<Outflow>
    outflow("outflow", "No wall: fluid that passes through the surface leaves the case.");
} // namespace Lahar
