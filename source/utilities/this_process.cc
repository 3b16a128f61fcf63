// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/this_process.h>

#include <unistd.h>

#include <array>

namespace Lahar
{
  std::string host_name()
  {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 && name[0] != 0 ? name.data() : "unknown";
  }



  std::string process_name()
  {
    return host_name() + "-" + std::to_string(getpid());
  }
} // namespace Lahar
