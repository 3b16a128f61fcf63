// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_process_start_h
#define lahar_utilities_process_start_h

#include <string>

namespace Lahar
{
  /**
   * What must be in order before the constructors of any library run; the executable names it in its section
   * ".preinit_array", which the loader calls first, with the arguments of main() and the environment.
   *
   * - Standard input, output and error are open (to /dev/null if they were closed): else the first file that is opened
   *   takes the place of the standard output, and what is printed goes into it.
   * - There is address space for what BLAS and MPI take at their start: OpenBLAS tries for ever to get its buffers if there
   *   is none. Else the program ends with status 1 and a message.
   */
  void prepare_process(int n_words, char **words, char **environment);

  /// Let BLAS take the buffers that it keeps, as long as there is room for them.
  void reserve_blas_buffers();

  /// Let a crash say so. Where the address space is limited, a library that has got no memory is taken for the reason, and
  /// the status is 1 instead of the signal's.
  void report_crashes();

  /// The limit of the address space as in " (ulimit -v: 500000 kB)", or nothing if there is none.
  std::string address_space_limit();
} // namespace Lahar

#endif
