// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/appended_file.h>
#include <lahar/utilities/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace Lahar
{
  AppendedFile::AppendedFile(const std::string &file_name)
    : file_name(file_name)
  {}



  void AppendedFile::begin()
  {
    file.close();
    n_bytes = 0;
    file.open(file_name, std::ios::binary | std::ios::trunc);
    if (!file)
      fail(std::strerror(errno));
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
    std::filesystem::resize_file(file_name, size, error);
    if (error)
      fail(error.message());
    file.open(file_name, std::ios::binary | std::ios::app);
    if (!file)
      fail(std::strerror(errno));
    n_bytes = size;
    return true;
  }



  void AppendedFile::append(const std::string &lines)
  {
    file << lines << std::flush;
    if (!file)
    {
      const std::string reason = std::strerror(errno);
      file.close();
      std::error_code ignored; // the first error is the one to tell
      std::filesystem::resize_file(file_name, n_bytes, ignored);
      fail(reason);
    }
    n_bytes += lines.size();
  }



  void AppendedFile::fail(const std::string &reason) const
  {
    throw RunError("Cannot write '" + file_name + "': " + reason + ".");
  }
} // namespace Lahar
