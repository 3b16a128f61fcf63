// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// v is that of the surface, for the fluid that lies on it.
  class NoSlip : public SurfaceLaw
  {
  public:
    bool lands() const override
    {
      return true;
    }

    bool sticks() const override
    {
      return true;
    }
  };



  static const Factory<SurfaceLaw>::Registration<NoSlip>
    no_slip("no slip", "Fluid that comes to lie on the surface sticks to it.");
} // namespace Lahar
