// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/factory.h>

namespace Lahar
{
  std::vector<std::string> &doubled_model_names()
  {
    static std::vector<std::string> names;
    return names;
  }
} // namespace Lahar
