// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/boundary_shape.h>
#include <lahar/geometry/point_lists.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /// Polylines in the plane. One whose last point is its first one is closed: a rigid body, or a tank.
  class PolylineBoundary : public BoundaryShape<2>
  {
  public:
    static void declare_parameters(Parameters &prm)
    {
      prm.declare_list(
        "Points", "", ';',
        "Polylines, each as 'x, y : x, y ...', separated by ';'. Lengths in m. A line whose last point "
        "is its first one is a closed body, or a tank if fluid lies wholly inside.");
    }

    void parse_parameters(Parameters &prm) override
    {
      const std::string allowed = "at least two different points for each line, neighbours apart";
      for (const std::vector<Point<2>> &points : parse_point_lists<2>(prm, "Points"))
      {
        WallShape<2> line;
        line.corners = points;
        if (points.size() > 2 && points.front() == points.back())
        {
          line.closed = true;
          line.corners.pop_back();
        }
        bool has_length = line.corners.size() >= 2;
        for (unsigned int i = 1; i < line.corners.size(); ++i)
          has_length = has_length && line.corners[i] != line.corners[i - 1];
        if (!has_length || (line.closed && line.corners.back() == line.corners.front()))
          prm.throw_wrong_value("Points", allowed);
        lines.push_back(line);
      }
      if (lines.empty())
        prm.throw_wrong_value("Points", allowed);
    }

    std::vector<WallShape<2>> walls() const override
    {
      return lines;
    }

  private:
    std::vector<WallShape<2>> lines;
  };



  static const Factory<BoundaryShape<2>>::Registration<PolylineBoundary> polyline("polyline", "Polylines.");
} // namespace Lahar
