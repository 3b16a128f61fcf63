// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_exceptions_h
#define lahar_utilities_exceptions_h

#include <stdexcept>
#include <string>

namespace Lahar
{
  /// The input is wrong: the program ends with exit status 2 before the first step.
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {}
  };

  /// The computation failed: the program ends with exit status 1; what was written stays readable.
  class RunError : public std::runtime_error
  {
  public:
    explicit RunError(const std::string &message)
      : std::runtime_error(message)
    {}
  };
} // namespace Lahar

#endif
