// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/facet_geometry.h>
#include <lahar/geometry/sharp_edges.h>
#include <lahar/initial/contact_at_start.h>
#include <lahar/initial/initial_geometry.h>
#include <lahar/utilities/true_on_all_ranks.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace Lahar
{
  namespace
  {
    template <int dim>
    std::string to_text(const Point<dim> &p)
    {
      std::ostringstream text;
      text << '(' << p << ')';
      return text.str();
    }

    /// The point of the walls nearest to @p point, of which some are nearer than @p distance or just beyond.
    template <int dim>
    Point<dim> nearest_point_of(const Walls<dim> &walls, const Point<dim> &point, const double distance)
    {
      Point<dim> nearest;
      double smallest = std::numeric_limits<double>::max();
      for (const unsigned int f : walls.near(point, 2. * distance))
      {
        const Point<dim> candidate = nearest_point<dim>(walls.facets()[f].corners, point);
        if (candidate.distance(point) < smallest)
        {
          smallest = candidate.distance(point);
          nearest  = candidate;
        }
      }
      return nearest;
    }
  } // namespace



  template <int dim>
  void InitialGeometry<dim>::check_body_sizes(const double h) const
  {
    for (const auto &body : bodies)
    {
      const Box<dim> box = body->box();
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double extent = box.upper[d] - box.lower[d];
        if (h > extent * (1. + 1e-10))
        {
          std::ostringstream message;
          message << "Parameter 'Mesh size' is " << h << " m, larger than fluid " << body->name()
                  << ", which is " << extent << " m in direction "
                  << "xyz"[d] << ". Allowed: at most the size of every body.";
          throw InputError(message.str());
        }
      }
    }
  }



  template <int dim>
  void InitialGeometry<dim>::check_overlaps(const Fillings &fillings, const double h,
                                            const MPI_Comm &communicator) const
  {
    const auto tolerance = [h](const FluidBody<dim> &body) { return touching * h + body.roughness(); };
    const auto overlaps  = [&](const FluidBody<dim> &body, const Point<dim> &p) {
      return body.signed_distance(p) < -tolerance(body);
    };
    const auto check = [&](const FluidBody<dim> &body, const Point<dim> &p, const std::string &name) {
      if (overlaps(body, p))
        throw InputError(
          "Fluid " + body.name() + " overlaps " + name + " at " + to_text(p) +
          " m. Fluid and walls may touch, not overlap; fluid round a body has a 'Shape = mesh' with a hole.");
    };

    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const Box<dim> box = bodies[b]->box();
      for (const WallShape<dim> &wall : wall_shapes)
      {
        for (const Point<dim> &p : wall.samples(h))
          if (box.contains(p, 0.))
            check(*bodies[b], p, "boundary " + wall.name);
        if (true_on_all_ranks(wall.holds(fillings[b].position, touching * h), communicator))
          continue;
        const auto is_enclosed = [&](const Point<dim> &p) { return wall.encloses(p, tolerance(*bodies[b])); };
        if (const auto p = first_of<dim>(fillings[b], is_enclosed, communicator))
          throw InputError(
            "Fluid " + bodies[b]->name() + " overlaps boundary " + wall.name + " at " + to_text(*p) +
            " m, whose line is closed and so a rigid body. Allowed: fluid and walls that touch; fluid that "
            "lies wholly inside a closed line, as in a tank.");
      }
      for (unsigned int other = 0; other < bodies.size(); ++other)
        if (b != other)
          if (const auto p = first_of<dim>(
                fillings[other], [&](const Point<dim> &q) { return overlaps(*bodies[b], q); }, communicator))
            check(*bodies[b], *p, "fluid " + bodies[other]->name());
    }
  }



  template <int dim>
  void InitialGeometry<dim>::check_solids(const Fillings &fillings, const SolidContour<dim> &solids,
                                          const double h, const MPI_Comm &communicator) const
  {
    if (solids.facets().empty())
      return;
    const double tolerance = touching * h;
    const Walls<dim> facets(solids.wall_facets());
    const auto check = [&](const std::string &what, const Point<dim> &p, const bool overlaps) {
      if (overlaps)
        throw InputError(what + " overlaps a solid at " + to_text(p) +
                         " m. Fluid, walls and solids may touch, not overlap.");
    };
    const auto is_deep_inside = [&](const Point<dim> &p, const double depth) {
      return solids.is_inside(p) && !is_near(facets, p, depth);
    };
    for (const WallShape<dim> &wall : wall_shapes)
      for (const Point<dim> &p : wall.samples(h))
        check("Boundary " + wall.name, p, is_deep_inside(p, tolerance + 2. * solids.unevenness()));
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const double depth = tolerance + bodies[b]->roughness();
      if (const auto p = first_of<dim>(
            fillings[b], [&](const Point<dim> &q) { return is_deep_inside(q, depth); }, communicator))
        check("Fluid " + bodies[b]->name(), *p, true);
      for (const WallFacet<dim> &facet : solids.wall_facets())
        check("Fluid " + bodies[b]->name(), facet.corners[0],
              bodies[b]->signed_distance(facet.corners[0]) < -depth);
    }
  }



  template <int dim>
  std::vector<Point<dim>> InitialGeometry<dim>::contacts(const WallShape<dim> &wall, const Fillings &fillings,
                                                         const SolidContour<dim> &solids,
                                                         const MeshSize<dim> &h,
                                                         const MPI_Comm &communicator) const
  {
    const Walls<dim> facets(wall.facets());
    std::vector<Point<dim>> result;
    // Of a row of facets along a wall in the plane, the ends; the wall divides what is between them.
    const auto add_ends = [&](const std::vector<std::array<Point<dim>, dim>> &row, const auto &distance) {
      std::vector<Point<dim>> in_row;
      for (const auto &corners : row)
        if (std::all_of(corners.begin(), corners.end(),
                        [&](const Point<dim> &p) { return is_near(facets, p, distance(p)); }))
          in_row.insert(in_row.end(), corners.begin(), corners.end());
      for (const Point<dim> &p : in_row)
        if (dim == 3 || std::count(in_row.begin(), in_row.end(), p) == 1)
          result.push_back(nearest_point_of(facets, p, distance(p)));
    };
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const auto distance = [&](const Point<dim> &p) { return contact * h(p) + bodies[b]->roughness(); };
      const auto touches  = [&](const Point<dim> &p) { return is_near(facets, p, distance(p)); };
      DividedPoints<dim> touching_points;
      for (std::size_t i = 0; dim == 3 && i < fillings[b].size(); ++i)
        if (touches(fillings[b].position[i]))
          touching_points.append(fillings[b].position[i], fillings[b].number[i]);
      for (const Point<dim> &p : dim == 2 ? bodies[b]->corners() : all_points(touching_points, communicator))
        if (touches(p))
          result.push_back(nearest_point_of(facets, p, distance(p)));
      if (dim == 2)
        add_ends(bodies[b]->contour(), distance);
    }
    std::vector<std::array<Point<dim>, dim>> of_solids;
    for (const WallFacet<dim> &facet : solids.wall_facets())
      of_solids.push_back(facet.corners);
    add_ends(of_solids, [&](const Point<dim> &p) { return touching * h(p); });
    return result;
  }



  template <int dim>
  std::vector<std::pair<Point<dim>, unsigned int>>
  InitialGeometry<dim>::create_walls(const MeshSize<dim> &h, const Fillings &fillings,
                                     const SolidContour<dim> &solids, Walls<dim> &walls,
                                     const MPI_Comm &communicator) const
  {
    const Walls<dim> solid_facets(solids.wall_facets_that_land(false));
    std::vector<WallFacet<dim>> facets;
    std::vector<std::pair<Point<dim>, unsigned int>> points;
    for (const WallShape<dim> &wall : wall_shapes)
    {
      for (const WallFacet<dim> &facet : wall.facets())
        facets.push_back(facet);
      if (!wall.lands)
        for (const Point<dim> &p : wall.particles(contacts(wall, fillings, solids, h, communicator), h))
          if (!is_near(solid_facets, p, contact * h(p)))
            points.emplace_back(p, wall.boundary);
    }
    std::vector<std::string> names;
    for (const Boundary<dim> &boundary : boundaries)
      names.push_back(boundary.name);
    walls = Walls<dim>(facets, names);
    for (const auto &[p, boundary] : points_on_sharp_edges(walls, h))
      if (!is_near(solid_facets, p, contact * h(p)) &&
          std::none_of(bodies.begin(), bodies.end(), [&p = p, &h](const auto &body) {
            return body->signed_distance(p) < 0.6 * h(p) + body->roughness();
          }))
        points.emplace_back(p, boundary);
    return points;
  }



  template <int dim>
  std::string InitialGeometry<dim>::wall_name(unsigned int facet) const
  {
    for (const WallShape<dim> &wall : wall_shapes)
    {
      const unsigned int n = wall.facets().size();
      if (facet < n)
        return wall.name;
      facet -= n;
    }
    Assert(false, ExcInternalError());
    return "";
  }



  template <int dim>
  std::optional<NarrowGap<dim>> InitialGeometry<dim>::narrow_gap(const MeshSize<dim> &h,
                                                                 const SolidContour<dim> &solids,
                                                                 const double most) const
  {
    std::vector<WallFacet<dim>> facets;
    std::vector<std::string> owners;
    for (const WallShape<dim> &wall : wall_shapes)
      for (const WallFacet<dim> &facet : wall.facets())
      {
        facets.push_back(facet);
        owners.push_back("boundary " + wall.name);
      }
    for (const WallFacet<dim> &facet : solids.wall_facets())
    {
      facets.push_back(facet);
      owners.push_back("a solid");
    }
    return NarrowGap<dim>::find(
      facets, owners,
      [&](const Point<dim> &p) {
        return solids.is_inside(p) || std::any_of(wall_shapes.begin(), wall_shapes.end(),
                                                  [&](const auto &wall) { return wall.encloses(p, 0.); });
      },
      h, most);
  }



  template <int dim>
  std::function<bool(const Simplex<dim> &, const ParticleCloud<dim> &)> InitialGeometry<dim>::region() const
  {
    double roughness = 0.;
    for (const auto &body : bodies)
      roughness = std::max(roughness, body->roughness());
    return [region = InitialRegion<dim>(bodies), roughness](const Simplex<dim> &simplex,
                                                            const ParticleCloud<dim> &cloud) {
      double spacing  = 0.;
      bool is_contact = false;
      for (const unsigned int i : simplex)
      {
        spacing    = std::max(spacing, cloud.spacing[i]);
        is_contact = is_contact || cloud.kind[i] != ParticleKind::fluid || cloud.in_contact(i);
      }
      return region.holds(corners_of<dim>(simplex, cloud.position),
                          (is_contact ? contact : touching) * spacing + roughness, 0.02 * spacing);
    };
  }



  template class InitialGeometry<2>;
  template class InitialGeometry<3>;
} // namespace Lahar
