// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_geometry_cone_body_h
#define lahar_geometry_cone_body_h

#include <lahar/geometry/fluid_body.h>

#include <array>

namespace Lahar
{
  /// A truncated cone or a cylinder; the inside is filled by fill_inside(), its contour by rings.
  class ConeBody : public FluidBody<3>
  {
  public:
    /// @param base and @p top the centres of its ends, which differ. Lengths in m; both radii are positive.
    ConeBody(const std::string &name, const Point<3> &base, const Point<3> &top, const double base_radius,
             const double top_radius);

    Box<3> box() const override;
    double volume() const override;
    double signed_distance(const Point<3> &point) const override;
    DividedPoints<3> fill(const MeshSize<3> &h, const MPI_Comm &communicator) const override;

  private:
    Point<3> base, top;
    double base_radius, top_radius, height;
    std::array<Tensor<1, 3>, 3>
      axes; ///< right-handed and of unit length; the last one points from the base to the top
  };
} // namespace Lahar

#endif
