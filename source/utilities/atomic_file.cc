// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/exceptions.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

namespace Lahar
{
  void write_atomically(const std::string &file_name, const std::function<void(std::ostream &)> &write)
  {
    // Whatever goes wrong before all of it is there, memory among it, leaves no file.
    std::ostringstream text;
    write(text);
    const std::string temporary = file_name + ".part";
    std::ofstream file(temporary);
    file << text.str();
    file.close();
    if (!file || std::rename(temporary.c_str(), file_name.c_str()) != 0)
    {
      const std::string reason = std::strerror(errno);
      std::remove(temporary.c_str());
      throw RunError("Cannot write '" + file_name + "': " + reason + ".");
    }
  }
} // namespace Lahar
