// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/utilities/atomic_file.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/output_directory.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <regex>

namespace Lahar
{
  namespace
  {
    const std::string ending = "(\\.[^/]*)?\\.part";

    /// All names that the program gives to files, in the directory and in `checkpoint`.
    const std::string names = "parameters\\.prm|log|statistics|convergence|solution\\.pvd|"
                              "solution-\\d+(\\.\\d+)?\\.p?vtu|solid-\\d+\\.vtu|walls(-\\d+)?\\.vtu|"
                              "checkpoint/state|checkpoint/piece-\\d+-\\d+-of-\\d+";

    /// Those of them that a start has.
    const std::string names_of_start = "parameters\\.prm|log|solution\\.pvd|solution-00000(\\.\\d+)?\\.p?vtu|"
                                       "solid-00000\\.vtu|walls(-00000)?\\.vtu";

    /// Whether the log of a run or of a start has a line of a step.
    bool has_steps(const std::filesystem::path &log)
    {
      std::ifstream file(log);
      for (std::string line; std::getline(file, line);)
        if (line.compare(0, 5, "step ") == 0)
          return true;
      return false;
    }

    /// Where the open directory is now, by the system's word.
    std::string place_of(const int descriptor)
    {
      std::error_code error;
      return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error).string();
    }

    bool is_same_directory(const int descriptor, const std::string &name)
    {
      struct stat held, found;
      return ::fstat(descriptor, &held) == 0 && ::stat(name.c_str(), &found) == 0 &&
             held.st_dev == found.st_dev && held.st_ino == found.st_ino;
    }

    bool is_removed(const int descriptor)
    {
      const std::string place = place_of(descriptor), mark = " (deleted)";
      struct stat held;
      return ::fstat(descriptor, &held) != 0 || held.st_nlink == 0 ||
             (place.size() > mark.size() &&
              place.compare(place.size() - mark.size(), mark.size(), mark) == 0);
    }
  } // namespace



  OutputDirectory::OutputDirectory(const std::string &name)
    : name(name)
  {}



  OutputDirectory::~OutputDirectory()
  {
    release();
    std::error_code ignored; // there is something in it
    for (auto directory = made_here.rbegin(); directory != made_here.rend() && !ignored; ++directory)
      std::filesystem::remove(*directory, ignored);
  }



  void OutputDirectory::release()
  {
    lock.release();
    if (descriptor >= 0)
      ::close(descriptor);
    descriptor = -1;
  }



  void OutputDirectory::refuse(const std::string &allowed) const
  {
    throw InputError("Parameter 'Output directory' is '" + name + "'. " + allowed + ".");
  }



  void OutputDirectory::open()
  {
    std::error_code error;
    std::filesystem::create_directories(name, error);
    if (descriptor >= 0)
      ::close(descriptor);
    descriptor = error ? -1 : ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
      throw RunError("Cannot create '" + name + "': " + (error ? error.message() : std::strerror(errno)) +
                     ".");
  }



  void OutputDirectory::take(const Use use)
  {
    std::error_code error;
    if (use == Use::resume && !std::filesystem::exists(name, error))
      return; // the checkpoint is missed
    std::filesystem::path whole;
    for (const auto &part : std::filesystem::absolute(name, error).lexically_normal())
      if (whole /= part; !part.empty() && !std::filesystem::exists(whole, error))
        made_here.push_back(whole);
    std::string holder;
    try
    {
      open();
      holder = lock.acquire(name + "/lock");
    }
    catch (const RunError &reason)
    {
      refuse(std::string("Allowed: a directory that can be created and written to (") + reason.what() + ")");
    }
    if (!holder.empty())
      refuse("Allowed: a directory that no other process computes in; " + holder);
    if (use != Use::begin)
      return;
    std::vector<std::filesystem::path> found = files_of_runs(false);
    // No run, but perhaps the case of this one.
    found.erase(std::remove(found.begin(), found.end(), std::filesystem::path(name) / "parameters.prm"),
                found.end());
    if (!found.empty())
      refuse("Allowed: a directory without an earlier run, but there is '" + found.front().string() + "'; " +
             (std::filesystem::exists(std::filesystem::path(name) / "checkpoint" / "state", error)
                ? "option --resume goes on from its checkpoint"
                : "it has no checkpoint from which option --resume could go on") +
             ", option --overwrite removes its files and begins anew");
  }



  std::vector<std::filesystem::path> OutputDirectory::files_of_runs(const bool temporary) const
  {
    const std::regex wanted(temporary ? "(" + names + ")" + ending : names);
    std::vector<std::filesystem::path> result;
    for (const std::string folder : {"", "checkpoint/"})
    {
      std::error_code error;
      for (std::filesystem::directory_iterator entry(std::filesystem::path(name) / folder, error), end;
           !error && entry != end; entry.increment(error))
        if (std::regex_match(folder + entry->path().filename().string(), wanted) &&
            !entry->is_directory(error))
          result.push_back(entry->path());
    }
    std::sort(result.begin(), result.end());
    return result;
  }



  std::string OutputDirectory::file_of_run() const
  {
    // That of a run that has lost some of its files, too.
    const std::filesystem::path folder(name), log = folder / "log";
    const std::regex of_start(names_of_start);
    const std::vector<std::filesystem::path> files = files_of_runs(false);
    const auto has                                 = [&](const std::filesystem::path &file) {
      return std::find(files.begin(), files.end(), file) != files.end();
    };
    for (const std::filesystem::path &file : {folder / "statistics", folder / "checkpoint" / "state"})
      if (has(file))
        return file.string();
    for (const std::filesystem::path &file : files)
      if (!std::regex_match(file.lexically_relative(folder).string(), of_start))
        return file.string();
    if (has(log) && (!has(folder / "parameters.prm") || has_steps(log)))
      return log.string();
    for (const std::filesystem::path &file : files)
      if (!has(log) && file != folder / "parameters.prm") // perhaps the case of this start
        return file.string();
    return "";
  }



  void OutputDirectory::clear() const
  {
    remove_temporaries();
    for (const std::filesystem::path &file : files_of_runs(false))
    {
      std::error_code error;
      std::filesystem::remove(file, error);
      if (error)
        throw RunError("Cannot remove '" + file.string() + "': " + error.message() + ".");
    }
  }



  void OutputDirectory::remove_temporaries() const
  {
    for (const std::filesystem::path &file : files_of_runs(true))
    {
      std::error_code error;
      std::filesystem::remove(file, error);
      if (error)
        throw RunError("Cannot remove '" + file.string() + "': " + error.message() + ".");
    }
  }



  std::string OutputDirectory::mend()
  {
    if (descriptor < 0)
      return "";
    const bool is_there = is_same_directory(descriptor, name);
    if (is_there && lock.is_kept())
      return "";
    if (!is_there && !is_removed(descriptor))
      throw RunError(
        "Output directory '" + name + "' has been renamed to '" + place_of(descriptor) +
        "' while the run wrote to it. Give it its name again: option --resume goes on from the checkpoint "
        "in it.");
    if (!is_there)
      open();
    const std::string holder = lock.acquire(name + "/lock");
    if (!holder.empty())
      throw RunError("Output directory '" + name + "' has been taken from this run: " + holder + ".");
    return is_there
             ? "Warning: '" + name + "/lock' was gone. It is there again, since this run goes on."
             : "Warning: directory '" + name +
                 "' was removed while the run wrote to it. It is there again, without the snapshots so far.";
  }
} // namespace Lahar
