// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/parameters.h>
#include <lahar/utilities/same_value.h>

#include <stdexcept>

namespace Lahar
{
  namespace
  {
    constexpr const char *separators = ",:;=";

    bool same_part(const std::string &a, const std::string &b)
    {
      if (a == b)
        return true;
      try
      {
        return to_number(a) == to_number(b);
      }
      catch (const std::invalid_argument &)
      {
        return false;
      }
    }
  } // namespace



  bool same_value(const std::string &a, const std::string &b)
  {
    for (std::size_t begin_a = 0, begin_b = 0;;)
    {
      const std::size_t end_a = a.find_first_of(separators, begin_a),
                        end_b = b.find_first_of(separators, begin_b);
      if (!same_part(Utilities::trim(a.substr(begin_a, end_a - begin_a)),
                     Utilities::trim(b.substr(begin_b, end_b - begin_b))))
        return false;
      if (end_a == std::string::npos || end_b == std::string::npos)
        return end_a == end_b;
      if (a[end_a] != b[end_b])
        return false;
      begin_a = end_a + 1;
      begin_b = end_b + 1;
    }
  }
} // namespace Lahar
