// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/this_process.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Lahar
{
  const std::string temporary_ending = ".part";

  namespace
  {
    /// Wait until what was written to a file, or the names in a directory, are on the disk. @return whether they are.
    bool sync(const std::string &name)
    {
      const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
      if (descriptor < 0)
        return false;
      // Some file systems have nothing to do for a directory and say so.
      const bool done = ::fsync(descriptor) == 0 || errno == EINVAL;
      const int error = errno;
      ::close(descriptor);
      errno = error;
      return done;
    }
  } // namespace



  void write_atomically(const std::string &file_name, const std::function<void(std::ostream &)> &write)
  {
    // Whatever goes wrong before all of it is there, memory among it, leaves no file.
    std::ostringstream text;
    write(text);
    const std::string temporary = file_name + "." + process_name() + temporary_ending,
                      directory = std::filesystem::path(file_name).parent_path().string();
    std::ofstream file(temporary);
    file << text.str();
    file.close();
    if (!file || !sync(temporary) || std::rename(temporary.c_str(), file_name.c_str()) != 0 ||
        !sync(directory.empty() ? "." : directory))
    {
      const std::string reason = std::strerror(errno);
      std::remove(temporary.c_str());
      throw RunError("Cannot write '" + file_name + "': " + reason + ".");
    }
  }
} // namespace Lahar
