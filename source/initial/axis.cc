// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/fluid_body.h>
#include <lahar/initial/axis.h>
#include <lahar/utilities/factory.h>

#include <sstream>

namespace Lahar
{
  namespace
  {
    /// How far the axis reaches beyond fluids and walls, over their extent.
    constexpr double reach = 100.;

    /// In so many moments of a run the motion of a boundary is looked at.
    constexpr unsigned int n_moments = 1000;

    /// A displacement or an angle below this is rounding, over one.
    constexpr double rounding = 1e-12;

    class AxisShape : public BoundaryShape<2>
    {
    public:
      AxisShape(const double lower, const double upper)
        : lower(lower)
        , upper(upper)
      {}

      void parse_parameters(Parameters & /*prm*/) override {}

      std::vector<WallShape<2>> walls() const override
      {
        WallShape<2> line;
        line.corners = {Point<2>(0., upper), Point<2>(0., lower)};
        return {line};
      }

    private:
      double lower, upper;
    };
  } // namespace



  Boundary<2> make_axis(Parameters &prm, const std::vector<Point<2>> &points)
  {
    const Box<2> box    = box_around(points);
    const double extent = box.lower.distance(box.upper);
    Boundary<2> axis;
    axis.name   = axis_name;
    axis.shape  = std::make_unique<AxisShape>(box.lower[1] - reach * extent, box.upper[1] + reach * extent);
    axis.law    = Factory<SurfaceLaw>::create("free slip", prm);
    axis.motion = Factory<BoundaryMotion<2>>::create("fixed", prm);
    return axis;
  }



  void check_boundary_about_axis(const Boundary<2> &boundary, const double start_time, const double end_time)
  {
    const auto fail = [&boundary](const std::string &what, const std::string &allowed) {
      throw InputError("Boundary '" + boundary.name + "' " + what +
                       ", but 'Geometry' is 'rotational symmetry'. Allowed: " + allowed + ".");
    };
    if (boundary.name == axis_name)
      fail("has the name of the axis", "another name; the axis x = 0 is a boundary by itself");
    if (boundary.inflow() != nullptr || boundary.outflow() != nullptr)
      fail("lets fluid in or out", "rigid boundaries");
    for (const WallShape<2> &wall : boundary.shape->walls())
      for (const WallFacet<2> &facet : wall.facets())
      {
        for (const Point<2> &corner : facet.corners)
          if (corner[0] < 0.)
          {
            std::ostringstream what;
            what << "has a point at x = " << corner[0] << " m";
            fail(what.str(), "x >= 0, the distance from the axis");
          }
        if (facet.corners[0][0] == 0. && facet.corners[1][0] == 0.)
          fail("has a piece along the axis x = 0", "pieces that end on it; the axis is a boundary by itself");
      }
    if (!boundary.motion->moves())
      return;
    for (unsigned int k = 0; k <= n_moments; ++k)
    {
      const RigidMotion<2> motion = boundary.motion->at(start_time + k * (end_time - start_time) / n_moments);
      if (std::abs(motion.shift[0]) > rounding || std::abs(motion.rotation[0][1]) > rounding)
        fail("turns or moves in x", "motion along y, the axis");
    }
  }
} // namespace Lahar
