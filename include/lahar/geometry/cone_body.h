#ifndef lahar_geometry_cone_body_h
#define lahar_geometry_cone_body_h

#include <lahar/geometry/fluid_body.h>

namespace Lahar
{
  /// An upright truncated cone, or a cylinder; the inside is filled by fill_inside(), its contour by rings.
  class ConeBody : public FluidBody<3>
  {
  public:
    /// @param base the centre of its base. Lengths in m; both radii and the height are positive.
    ConeBody(const std::string &name, const Point<3> &base, const double base_radius, const double top_radius,
             const double height);

    Box<3> box() const override;
    double signed_distance(const Point<3> &point) const override;
    std::vector<Point<3>> fill(const double h) const override;

  private:
    Point<3> base;
    double base_radius, top_radius, height;
  };
} // namespace Lahar

#endif
