// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_case_structure_h
#define lahar_utilities_case_structure_h

#include <lahar/utilities/assignment.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * What decides which entries a case has: its dimension, its plugins and the names of its parts. It is read before the
   * entries are declared.
   *
   * The entries are 'Dimension', 'Plugins' (names of files, separated by ';'), 'Fluids', 'Boundaries' and 'Solids'
   * (names, separated by ','). As with all entries, the last assignment counts. A name has letters, digits, blanks and
   * "-_.", and occurs once in its list.
   */
  struct CaseStructure
  {
    unsigned int dimension = 2;
    std::vector<std::string> plugins; ///< absolute names of files
    std::vector<std::string> fluids, boundaries, solids;

    CaseStructure() = default;

    /// @throws InputError for a wrong name, with the place. A wrong dimension counts as 2; it shows when all parameters are
    /// read.
    explicit CaseStructure(const std::vector<Assignment> &assignments);

    /// Where there is no part of a kind, make one, to show which entries there are.
    void complete();
  };
} // namespace Lahar

#endif
