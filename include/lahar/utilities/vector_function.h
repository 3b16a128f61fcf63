// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_vector_function_h
#define lahar_utilities_vector_function_h

#include <deal.II/base/function_parser.h>

#include <lahar/utilities/parameters.h>

#include <memory>

namespace Lahar
{
  /// Zero as the text of such a function: "0; 0" or "0; 0; 0".
  template <int dim>
  std::string zero_function();

  /**
   * The vector function that @p entry holds: one expression of x, y (, z) and, with @p of_time, t for each component,
   * separated by ';'.
   * @throws InputError for what muParser does not read.
   */
  template <int dim>
  std::shared_ptr<FunctionParser<dim>> parse_vector_function(const Parameters &prm, const std::string &entry,
                                                             const bool of_time);
} // namespace Lahar

#endif
