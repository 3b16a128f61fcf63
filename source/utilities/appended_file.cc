// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/appended_file.h>
#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/exceptions.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace Lahar
{
  AppendedFile::AppendedFile(const std::string &file_name)
    : file_name(file_name)
  {}



  AppendedFile::~AppendedFile()
  {
    close();
  }



  void AppendedFile::open(const int flags)
  {
    close();
    descriptor = ::open(file_name.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | flags, 0666);
    if (descriptor < 0)
      fail();
  }



  void AppendedFile::close()
  {
    if (descriptor >= 0)
      ::close(descriptor);
    descriptor = -1;
  }



  void AppendedFile::begin()
  {
    n_bytes = 0;
    open(O_CREAT | O_TRUNC);
  }



  void AppendedFile::check(const std::uintmax_t size) const
  {
    std::error_code error;
    const std::uintmax_t found = std::filesystem::file_size(file_name, error);
    if (!error && found < size)
      throw InputError("Option --resume: '" + file_name + "' holds " + std::to_string(found) + " bytes, " +
                       std::to_string(size) +
                       " when the checkpoint was written. Allowed: the file as the run has left it, or none, "
                       "to go on without the lines so far.");
  }



  bool AppendedFile::resume(const std::uintmax_t size)
  {
    std::error_code error;
    if (!std::filesystem::exists(file_name, error))
    {
      begin();
      return false;
    }
    open(0);
    if (::ftruncate(descriptor, size) != 0)
      fail();
    n_bytes = size;
    return true;
  }



  bool AppendedFile::go_on()
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file_name, error);
    return resume(error ? 0 : size);
  }



  void AppendedFile::append(const std::string &lines)
  {
    for (std::size_t done = 0; done < lines.size();)
    {
      const ::ssize_t n = ::write(descriptor, lines.data() + done, lines.size() - done);
      if (n < 0 && errno == EINTR)
        continue;
      if (n < 0)
      {
        const std::string reason = std::strerror(errno);
        if (::ftruncate(descriptor, n_bytes) != 0) // the first error is the one to tell
          close();
        fail(reason);
      }
      done += n;
    }
    n_bytes += lines.size();
  }



  bool AppendedFile::mend(const bool is_ours)
  {
    if (descriptor < 0)
      return false;
    struct stat kept, found;
    if (::fstat(descriptor, &kept) != 0)
      fail();
    if (::stat(file_name.c_str(), &found) != 0)
    {
      if (errno != ENOENT && errno != ENOTDIR)
        fail();
    }
    else if (kept.st_dev == found.st_dev && kept.st_ino == found.st_ino)
    {
      if (!is_ours)
        n_bytes = found.st_size;
      if (static_cast<std::uintmax_t>(found.st_size) == n_bytes)
        return false;
      throw RunError(
        "'" + file_name + "' holds " + std::to_string(found.st_size) + " bytes, the run wrote " +
        std::to_string(n_bytes) +
        ": something else has changed it. Option --resume goes on from the last checkpoint once the "
        "file is as the run wrote it, or away");
    }
    std::string lines(n_bytes, ' ');
    for (std::uintmax_t done = 0; done < n_bytes;)
    {
      const ::ssize_t n = ::pread(descriptor, &lines[done], n_bytes - done, done);
      if (n <= 0)
        throw RunError("'" + file_name + "' was removed while the run went on, and its lines are lost (" +
                       (n < 0 ? std::strerror(errno) : "they cannot be read any more") +
                       "). Option --resume goes on from the last checkpoint");
      done += n;
    }
    write_atomically(file_name, [&](std::ostream &file) { file << lines; });
    open(0);
    return true;
  }



  void AppendedFile::sync() const
  {
    if (descriptor >= 0 && ::fsync(descriptor) != 0 && errno != EINVAL)
      fail();
  }



  void AppendedFile::fail(const std::string &reason) const
  {
    throw RunError("Cannot write '" + file_name + "': " + reason + ".");
  }



  void AppendedFile::fail() const
  {
    fail(std::strerror(errno));
  }
} // namespace Lahar
