// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/plugin.h>

#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/factory.h>
#include <lahar/utilities/failure.h>
#include <lahar/utilities/plugins.h>

#include <dlfcn.h>

#include <filesystem>

#define LAHAR_TEXT(name) #name
#define LAHAR_TEXT_OF(name) LAHAR_TEXT(name)

extern "C" const char LAHAR_BUILD[] = LAHAR_TEXT_OF(LAHAR_BUILD);

namespace Lahar
{
  namespace
  {
    [[noreturn]] void fail(const std::string &file_name, const std::string &allowed)
    {
      throw InputError("Parameter 'Plugins' has '" + file_name + "'. Allowed: " + allowed + ".");
    }



    /// What the dynamic linker has to say, without the file's name, which it begins with.
    std::string linker_message(const std::string &file_name)
    {
      const char *text          = dlerror();
      const std::string message = text == nullptr ? "" : text, start = file_name + ": ";
      return message.rfind(start, 0) == 0 ? message.substr(start.size()) : message;
    }



    void *open_library(const std::string &file_name)
    {
      // The loader is declared to throw nothing, and passes on what a library's constructors throw. A compiler that saw
      // which function it is would leave out what catches that.
      void *(*const volatile open)(const char *, int) = dlopen;
      try
      {
        return open(file_name.c_str(), RTLD_NOW | RTLD_LOCAL);
      }
      catch (...)
      {
        fail(file_name, "plugins that can be loaded; this one throws: " + Failure::current().message);
      }
    }



    void load(const std::string &file_name)
    {
      if (!std::filesystem::is_regular_file(file_name))
        fail(file_name, "shared libraries that exist");
      const std::string build = LAHAR_BUILD, rule = "plugins built for this program, " + build,
                        whole = std::filesystem::absolute(file_name).string(); // not searched for
      void *library           = open_library(whole);
      if (library == nullptr)
        fail(file_name, rule + " (" + linker_message(whole) + ")");
      // lahar_add_plugin() of LaharConfig.cmake defines it.
      if (dlsym(library, "lahar_plugin") == nullptr)
        fail(file_name, rule + "; this library is no plugin");
    }
  } // namespace



  void load_plugins(const std::vector<std::string> &file_names)
  {
    for (const std::string &file_name : file_names)
    {
      load(file_name);
      if (!doubled_model_names().empty())
        fail(file_name, "plugins whose models have names of their own; there is a model '" +
                          doubled_model_names().front() + "' already");
    }
  }
} // namespace Lahar
