// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_outflow_h
#define lahar_boundary_outflow_h

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/time_functions.h>
#include <lahar/utilities/time_table.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Fluid leaves the case through a surface, which is no wall. What takes it away, and what presses there where a level
   * is given, is a matter of Outlets.
   */
  class Outflow : public SurfaceLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// @throws InputError, also if both 'Level' and 'Level table' are there.
    void parse_parameters(Parameters &prm) override;

    bool lands() const override
    {
      return false;
    }

    /// A vector to the side where the fluid goes, its components as they are given.
    const std::vector<double> &direction() const
    {
      return components;
    }

    /// Whether the fluid behind the surface has a level; otherwise there is none.
    bool has_level() const
    {
      return !source.empty();
    }

    /// Its last coordinate at @p time (s), m. @throws RunError if it is not finite.
    double level(const double time) const;

    /// @throws InputError if there is a level that is not finite between two times (s), as seen at a thousand of them.
    void check_times(const double from, const double to) const;

    /// The path of an entry, for messages.
    std::string path(const std::string &entry) const
    {
      return section + entry;
    }

    /// That of the entry that gives the level.
    std::string level_path() const
    {
      return path(source);
    }

  private:
    std::vector<double> components;
    TimeFunctions function;
    TimeTable table;
    std::string section, source; ///< source: the entry that gives the level
  };
} // namespace Lahar

#endif
