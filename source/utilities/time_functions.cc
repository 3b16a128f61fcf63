// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/time_functions.h>

#include <cmath>

namespace Lahar
{
  TimeFunctions::TimeFunctions(const Parameters &prm, const std::string &entry, const unsigned int n)
    : function(std::make_shared<FunctionParser<1>>(n))
    , path(prm.path(entry))
    , text(prm.get(entry))
  {
    try
    {
      const std::vector<std::string> components = split_list(text, ';');
      AssertThrow(components.size() == n, ExcDimensionMismatch(components.size(), n));
      function->initialize("t", components, {{"pi", numbers::PI}}, false);
      for (unsigned int i = 0; i < n; ++i)
        function->value(Point<1>(), i);
    }
    catch (const std::exception &)
    {
      prm.throw_wrong_value(entry, n == 1 ? "one function of the time t"
                                          : std::to_string(n) + " functions of the time t, separated by ';'");
    }
  }



  std::vector<double> TimeFunctions::operator()(const double time) const
  {
    std::vector<double> result;
    for (unsigned int i = 0; i < function->n_components; ++i)
    {
      result.push_back(function->value(Point<1>(time), i));
      if (!std::isfinite(result.back()))
        throw RunError("parameter '" + path + "', which is '" + text +
                       "', is not finite at t = " + std::to_string(time) + " s");
    }
    return result;
  }
} // namespace Lahar
