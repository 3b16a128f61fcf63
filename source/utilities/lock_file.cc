// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/lock_file.h>
#include <lahar/utilities/this_process.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <iomanip>
#include <sstream>
#include <thread>

namespace Lahar
{
  namespace
  {
    /// What the file says.
    struct Holder
    {
      std::string host, since;
      long process = 0;

      bool is_named() const
      {
        return process > 0;
      }

      std::string text() const
      {
        return "process " + std::to_string(process) + " on host '" + host + "' (since " + since + ")";
      }
    };

    Holder read_holder(const int descriptor)
    {
      std::array<char, 1000> data{};
      const ::ssize_t n = ::pread(descriptor, data.data(), data.size(), 0);
      std::istringstream text(std::string(data.data(), n > 0 ? n : 0));
      Holder holder;
      std::string word[3];
      if (!(text >> word[0] >> holder.host >> word[1] >> holder.process >> word[2]) || word[0] != "host" ||
          word[1] != "process" || word[2] != "since" || !std::getline(text >> std::ws, holder.since))
        return {};
      return holder;
    }

    std::string this_holder()
    {
      const std::time_t now = std::time(nullptr);
      std::tm utc{};
      gmtime_r(&now, &utc);
      std::ostringstream text;
      text << "host " << host_name() << "\nprocess " << getpid() << "\nsince "
           << std::put_time(&utc, "%Y-%m-%d %H:%M:%S UTC") << '\n';
      return text.str();
    }

    bool is_same_file(const int descriptor, const std::string &name)
    {
      struct stat held, found;
      return ::fstat(descriptor, &held) == 0 && ::stat(name.c_str(), &found) == 0 &&
             held.st_dev == found.st_dev && held.st_ino == found.st_ino;
    }

    /// How long a process that has just made the file has to write its name into it.
    constexpr std::chrono::milliseconds patience(1000), pause(20);
  } // namespace



  LockFile::~LockFile()
  {
    release();
  }



  std::string LockFile::acquire(const std::string &name)
  {
    release();
    const auto fail = [&] { throw RunError("Cannot write '" + name + "': " + std::strerror(errno) + "."); };
    const auto end  = std::chrono::steady_clock::now() + patience;
    while (true)
    {
      const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (file < 0)
        fail();
      const bool is_locked = ::flock(file, LOCK_EX | LOCK_NB) == 0,
                 is_held   = !is_locked && errno == EWOULDBLOCK;
      const Holder holder  = read_holder(file);
      // The one before may have removed it meanwhile, or not yet have written its name.
      if (!is_same_file(file, name) ||
          (is_held && !holder.is_named() && std::chrono::steady_clock::now() < end))
      {
        ::close(file);
        std::this_thread::sleep_for(pause);
        continue;
      }
      const bool is_elsewhere = holder.is_named() && holder.host != host_name(),
                 has_ended    = !is_elsewhere &&
                             (is_locked || (::kill(holder.process, 0) != 0 && errno == ESRCH));
      if (is_held || (holder.is_named() && !has_ended))
      {
        ::close(file);
        return (holder.is_named() ? holder.text() : "a process of unknown name") + " has it, says '" + name +
               "'" +
               (is_held ? ", and runs" : ". If that process has ended (look on that host), remove this file");
      }
      const std::string text = this_holder();
      if (::ftruncate(file, 0) != 0 ||
          ::pwrite(file, text.data(), text.size(), 0) != static_cast<::ssize_t>(text.size()))
      {
        const int error = errno;
        ::close(file);
        errno = error;
        fail();
      }
      descriptor = file;
      file_name  = name;
      return "";
    }
  }



  void LockFile::release()
  {
    if (descriptor < 0)
      return;
    if (is_kept())
      ::unlink(file_name.c_str()); // before the lock is given back, so that it is still this one's
    ::close(descriptor);
    descriptor = -1;
  }



  bool LockFile::is_kept() const
  {
    return descriptor >= 0 && is_same_file(descriptor, file_name);
  }
} // namespace Lahar
