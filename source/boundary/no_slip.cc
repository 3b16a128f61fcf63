// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// v is that of the surface.
  class NoSlip : public SurfaceLaw
  {
  public:
    bool slips() const override
    {
      return false;
    }
  };



  static const Factory<SurfaceLaw>::Registration<NoSlip> no_slip("no slip", "Fluid sticks to the surface.");
} // namespace Lahar
