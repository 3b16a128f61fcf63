// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// v is that of the surface, which carries particles: fluid meets it in the cells that join both.
  class WallParticles : public SurfaceLaw
  {
  public:
    bool lands() const override
    {
      return false;
    }
  };



  static const Factory<SurfaceLaw>::Registration<WallParticles>
    wall_particles("wall particles", "No slip, by particles that the surface carries.");
} // namespace Lahar
