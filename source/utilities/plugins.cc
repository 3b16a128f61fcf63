// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/plugin.h>
#include <lahar/utilities/exceptions.h>
#include <lahar/utilities/factory.h>
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



    void load(const std::string &file_name)
    {
      if (!std::filesystem::is_regular_file(file_name))
        fail(file_name, "shared libraries that exist");
      const std::string build = LAHAR_BUILD, rule = "plugins built for this program, " + build;
      void *library = nullptr;
      try
      {
        // With a slash: not searched for along the system's path.
        library = dlopen(std::filesystem::absolute(file_name).c_str(), RTLD_NOW | RTLD_LOCAL);
      }
      catch (const std::exception &error)
      {
        fail(file_name, std::string("plugins that can be loaded; this one throws: ") + error.what());
      }
      catch (...)
      {
        fail(file_name, "plugins that can be loaded; this one throws");
      }
      if (library == nullptr)
        fail(file_name, rule + " (" + linker_message(std::filesystem::absolute(file_name)) + ")");
      // lahar_setup_plugin() of LaharConfig.cmake defines it.
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
