// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_time_functions_h
#define lahar_utilities_time_functions_h

#include <deal.II/base/function_parser.h>

#include <lahar/utilities/parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Functions of the time t, as the user gives them: expressions separated by ';', as muParser reads them.
   */
  class TimeFunctions
  {
  public:
    TimeFunctions() = default;

    /// The @p n functions that @p entry of the handler's current section holds. @throws InputError for what muParser
    /// does not read.
    TimeFunctions(const Parameters &prm, const std::string &entry, const unsigned int n);

    /// Their values at @p time (s). @throws RunError if one is not finite.
    std::vector<double> operator()(const double time) const;

  private:
    std::shared_ptr<FunctionParser<1>> function;
    std::string path, text; ///< of the entry
  };
} // namespace Lahar

#endif
