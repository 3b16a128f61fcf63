// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/initial/initial_geometry.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Lahar
{
  template <int dim>
  void InitialGeometry<dim>::check_inflows(const double h) const
  {
    const auto fail = [&](const WallShape<dim> &wall, const Point<dim> &p, const std::string &what,
                          const std::string &allowed) {
      std::ostringstream message;
      message << "Boundary " << wall.name << " lets fluid in at (" << p << ") m, " << what
              << ". Allowed: " << allowed << ".";
      throw InputError(message.str());
    };
    for (const WallShape<dim> &wall : wall_shapes)
    {
      if (boundaries[wall.boundary].inflow() == nullptr)
        continue;
      const std::vector<Point<dim>> samples = wall.samples(h);
      for (const WallShape<dim> &other : wall_shapes)
      {
        if (&other == &wall)
          continue;
        const bool is_tank = std::any_of(bodies.begin(), bodies.end(), [&](const auto &body) {
          return other.holds(body->corners(), touching * h);
        });
        if (!is_tank)
          for (const Point<dim> &p : samples)
            if (other.encloses(p, touching * h))
              fail(wall, p, "inside boundary " + other.name + ", whose line is closed and so a rigid body",
                   "a boundary outside of rigid bodies");
        if (other.boundary == wall.boundary || boundaries[other.boundary].inflow() == nullptr)
          continue;
        const Walls<dim> facets(other.facets());
        for (const Point<dim> &p : samples)
          for (const unsigned int f : facets.near(p, touching * h))
            if (std::abs(facets.signed_distance(f, p)) < touching * h && facets.is_above(f, p, -0.1 * h))
              fail(wall, p, "where boundary " + other.name + " does so, too", "one inflow in one place");
      }
    }
  }



  template void InitialGeometry<2>::check_inflows(const double) const;
  template void InitialGeometry<3>::check_inflows(const double) const;
} // namespace Lahar
