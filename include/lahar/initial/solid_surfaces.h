// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_initial_solid_surfaces_h
#define lahar_initial_solid_surfaces_h

#include <lahar/boundary/surface_law.h>

#include <memory>
#include <vector>

namespace Lahar
{
  /**
   * The laws of the solids' surfaces, by solid.
   *
   * Fluid sticks to a solid by the nodes that both share. Where a law lets it slide the solid is slick: fluid lands on its
   * facets, as on a wall.
   */
  class SolidSurfaces
  {
  public:
    /// Declare subsection "Surface" of each solid.
    static void declare_parameters(Parameters &prm, const std::vector<std::string> &names);

    /// @throws InputError
    void parse_parameters(Parameters &prm, const std::vector<std::string> &names);

    const std::vector<std::unique_ptr<SurfaceLaw>> &laws() const
    {
      return all_laws;
    }

    /// Whether fluid slides along a solid, by solid.
    std::vector<bool> slick() const;

    /// Whether fluid slides along any solid.
    bool any_slick() const;

  private:
    std::vector<std::unique_ptr<SurfaceLaw>> all_laws;
  };
} // namespace Lahar

#endif
