// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/boundary/surface_law.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// n·v is that of the surface, the shear traction is zero.
  class FreeSlip : public SurfaceLaw
  {
  public:
    bool lands() const override
    {
      return true;
    }
  };



  static const Factory<SurfaceLaw>::Registration<FreeSlip>
    free_slip("free slip", "Fluid slides along the surface and does not leave it.");
} // namespace Lahar
