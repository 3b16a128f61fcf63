// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_plugins_h
#define lahar_utilities_plugins_h

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Load shared libraries whose models register themselves with their Factory, before parameters are declared. They stay
   * loaded.
   * @throws InputError for a file that is missing, is no plugin for this build of Lahar (lahar/plugin.h), throws while it
   *   is loaded or has a model whose name is taken.
   */
  void load_plugins(const std::vector<std::string> &file_names);
} // namespace Lahar

#endif
