// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_simulator_step_counters_h
#define lahar_simulator_step_counters_h

namespace Lahar
{
  /// What has been counted since the start of a run, on all ranks.
  struct StepCounters
  {
    unsigned int steps         = 0;
    unsigned int rejected      = 0; ///< steps that were repeated with half their length
    unsigned int forced_facets = 0; ///< of solids' contours that a Delaunay triangulation did not have
    unsigned int kept_out      = 0; ///< particles that were put back before a solid
    unsigned int left          = 0; ///< particles that have left the domain
    unsigned int gone_out      = 0; ///< particles that have passed through an outlet
    unsigned int cells         = 0; ///< of the fluid at present

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &steps &rejected &forced_facets &kept_out &left &gone_out &cells;
    }
  };
} // namespace Lahar

#endif
