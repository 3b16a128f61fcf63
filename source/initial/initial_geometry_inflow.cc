// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/initial/axis.h>
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



  template <int dim>
  void InitialGeometry<dim>::check_common_faces(const Fillings &fillings, const double h,
                                                const MPI_Comm &communicator) const
  {
    std::vector<WallFacet<dim>> facets;
    for (const WallShape<dim> &wall : wall_shapes)
      if (!wall.moves && boundaries[wall.boundary].name != axis_name)
        for (const WallFacet<dim> &facet : wall.facets())
          facets.push_back(facet);
    const Walls<dim> walls(facets);
    // The boundaries that lie on each other at a point, if there are such.
    const auto on_each_other = [&](const Point<dim> &p) -> std::vector<unsigned int> {
      std::vector<unsigned int> touched;
      for (const unsigned int f : walls.near(p, touching * h))
        if (std::abs(walls.signed_distance(f, p)) < touching * h && walls.is_above(f, p, -0.1 * h))
          touched.push_back(f);
      for (const unsigned int f : touched)
        for (const unsigned int other : touched)
          if (facets[f].boundary < facets[other].boundary &&
              std::abs(walls.normal(f) * walls.normal(other)) > 1. - 1e-6)
            return {facets[f].boundary, facets[other].boundary};
      return {};
    };
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (const auto p = first_of<dim>(
            fillings[b], [&](const Point<dim> &q) { return !on_each_other(q).empty(); }, communicator))
      {
        const std::vector<unsigned int> two = on_each_other(*p);
        std::ostringstream message;
        message << "Boundaries '" << boundaries[two[0]].name << "' and '" << boundaries[two[1]].name
                << "' lie on each other at (" << *p << ") m, where fluid " << bodies[b]->name()
                << " touches them. Allowed: one boundary, and so one law, in one place.";
        throw InputError(message.str());
      }
  }



  template void InitialGeometry<2>::check_inflows(const double) const;
  template void InitialGeometry<3>::check_inflows(const double) const;
  template void InitialGeometry<2>::check_common_faces(const Fillings &, const double,
                                                       const MPI_Comm &) const;
  template void InitialGeometry<3>::check_common_faces(const Fillings &, const double,
                                                       const MPI_Comm &) const;
} // namespace Lahar
