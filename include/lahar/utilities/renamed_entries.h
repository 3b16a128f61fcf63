// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_renamed_entries_h
#define lahar_utilities_renamed_entries_h

#include <string>

namespace Lahar
{
  /**
   * Where an entry or subsection stands that older parameter files have elsewhere.
   * @param path as in "Geometry/Fluid boxes".
   * @return for people, as in "'Fluids/NAME/box/Corners' with 'set Fluids = NAME' and 'Shape = box'"; empty for any other
   * path.
   */
  std::string new_spelling(const std::string &path);
} // namespace Lahar

#endif
