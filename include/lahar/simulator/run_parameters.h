// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_run_parameters_h
#define lahar_simulator_run_parameters_h

#include <lahar/utilities/parameters.h>

#include <string>

namespace Lahar
{
  /// The entries at the top level of every .prm file.
  struct RunParameters
  {
    std::string output_directory;
    double start_time        = 0.; ///< s
    double end_time          = 0.; ///< s
    double time_step         = 0.; ///< s
    double minimum_time_step = 0.; ///< s
    double maximum_time_step = 0.; ///< s
    double largest_movement  = 0.; ///< of a particle in a step, in units of its spacing
    double mesh_size         = 0.; ///< m
    double output_interval   = 0.; ///< s; zero: every step

    unsigned int steps_between_checkpoints = 0;  ///< zero: steps do not count
    double time_between_checkpoints        = 0.; ///< wall time in s; zero: it does not count

    static void declare_parameters(Parameters &prm);
    /// @throws InputError
    void parse_parameters(Parameters &prm);
  };
} // namespace Lahar

#endif
