// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/ground.h>
#include <lahar/geometry/ground_of_boundary.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Lahar
{
  namespace
  {
    template <typename Shape>
    Shape ground_of(Parameters &prm, const std::string &entry)
    {
      const InGroundOfBoundary section(prm, entry);
      return Shape(prm);
    }

    double elevation_at(const Terrain &terrain, const Point<3> &place)
    {
      return terrain.elevation({place[0], place[1]});
    }

    double elevation_at(const Profile &profile, const Point<2> &place)
    {
      const std::vector<Point<2>> &line = profile.points();
      const double rounding             = 1e-9 * (line.back()[0] - line.front()[0]);
      if (!(place[0] >= line.front()[0] - rounding && place[0] <= line.back()[0] + rounding))
        return std::numeric_limits<double>::quiet_NaN();
      return value_at(line, place[0]);
    }
  } // namespace



  template <int dim>
  Ground<dim>::Ground(Parameters &prm, const std::string &entry, const std::string &above)
    : ground(ground_of<std::conditional_t<dim == 2, Profile, Terrain>>(prm, entry))
    , path(prm.path(entry))
    , boundary(prm.get(entry))
    , above(above)
  {}



  template <int dim>
  double Ground<dim>::elevation(const Point<dim> &place) const
  {
    const double result = elevation_at(ground, place);
    if (std::isnan(result))
    {
      std::ostringstream message;
      message << "Parameter '" << path << "' is '" << boundary << "', and '" << above << "' has a point at ("
              << place << ") m. Allowed: points within the window of this ground.";
      throw InputError(message.str());
    }
    return result;
  }



  template <int dim>
  Point<dim> Ground<dim>::raised(const Point<dim> &drawn) const
  {
    Point<dim> result = drawn;
    result[dim - 1] += elevation(drawn);
    return result;
  }



  template <int dim>
  Box<dim> Ground<dim>::raised(const Box<dim> &drawn) const
  {
    constexpr unsigned int n = 20;
    double lowest = std::numeric_limits<double>::max(), highest = -lowest;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= (dim == 2 ? 0 : n); ++j)
      {
        Point<dim> place                         = drawn.lower;
        const std::array<unsigned int, 2> number = {{i, j}};
        for (unsigned int d = 0; d + 1 < dim; ++d)
          place[d] += number[d] * (drawn.upper[d] - drawn.lower[d]) / n;
        lowest  = std::min(lowest, elevation(place));
        highest = std::max(highest, elevation(place));
      }
    Point<dim> lower = drawn.lower, upper = drawn.upper;
    lower[dim - 1] += lowest;
    upper[dim - 1] += highest;
    return Box<dim>(lower, upper);
  }



  template class Ground<2>;
  template class Ground<3>;
} // namespace Lahar
