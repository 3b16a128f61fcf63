// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_outflow_h
#define lahar_boundary_outflow_h

#include <lahar/boundary/surface_law.h>

#include <string>
#include <vector>

namespace Lahar
{
  /**
   * Fluid leaves the case through a surface, which is no wall. What takes it away is a matter of Outlets.
   */
  class Outflow : public SurfaceLaw
  {
  public:
    static void declare_parameters(Parameters &prm);

    /// @throws InputError
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

    /// The path of the entry that gives it, for messages.
    const std::string &path() const
    {
      return entry_path;
    }

  private:
    std::vector<double> components;
    std::string entry_path;
  };
} // namespace Lahar

#endif
