// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/standard_output.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace Lahar
{
  void write_standard_output(const std::string &text)
  {
    for (std::size_t written = 0; written < text.size();)
    {
      const ssize_t n = write(STDOUT_FILENO, text.data() + written, text.size() - written);
      if (n < 0 && errno == EPIPE)
        return;
      if (n < 0 && errno != EINTR)
        throw RunError(std::string("Cannot write to the standard output: ") + std::strerror(errno) + ".");
      written += n > 0 ? n : 0;
    }
  }
} // namespace Lahar
