// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_same_value_h
#define lahar_utilities_same_value_h

#include <string>

namespace Lahar
{
  /**
   * Whether two values of an entry mean the same: lists, whose parts stand between ",", ":", ";" and "=", of the same
   * length with the same parts, which are numbers of the same value ("1.5e-2" and "0.015") or the same words. White
   * space around parts does not count.
   */
  bool same_value(const std::string &a, const std::string &b);
} // namespace Lahar

#endif
