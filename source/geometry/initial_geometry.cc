// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/initial_geometry.h>
#include <lahar/geometry/point_set.h>

#include <algorithm>
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

    template <int dim>
    bool is_near(const Walls<dim> &walls, const Point<dim> &point, const double distance)
    {
      for (const unsigned int f : walls.near(point, distance))
        if (std::abs(walls.signed_distance(f, point)) < distance && walls.is_above(f, point, distance))
          return true;
      return false;
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
          message << "Parameter 'Mesh size' is " << h << " m, larger than fluid body " << body->name()
                  << ", which is " << extent << " m in direction "
                  << "xyz"[d] << ". Allowed: at most the size of every body.";
          throw InputError(message.str());
        }
      }
    }
  }



  template <int dim>
  void InitialGeometry<dim>::check_number_of_particles(const MeshSize<dim> &mesh_size) const
  {
    const double h   = mesh_size.coarsest();
    double sum       = 0.;
    const auto check = [&](const double n, const std::string &name) {
      sum += n;
      if (!(sum <= max_particles))
      {
        std::ostringstream message;
        message << "Parameter 'Mesh size' is " << h << " m, which makes about " << n << " particles of "
                << name << (mesh_size.is_uniform() ? "" : " with 'Remeshing/Refined boxes'")
                << ". Allowed: 'Geometry/Largest number of particles', which is " << max_particles
                << ", of all bodies and walls.";
        throw InputError(message.str());
      }
    };
    for (const auto &body : bodies)
      check(body->estimate_size(h) + mesh_size.estimate_refinement(body->box(), dim),
            "fluid body " + body->name());
    for (const WallShape<dim> &wall : wall_shapes)
    {
      std::vector<Point<dim>> corners;
      for (const WallFacet<dim> &facet : wall.facets())
        corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
      check(wall.estimate_size(h) + mesh_size.estimate_refinement(box_around(corners), dim - 1),
            "wall " + wall.name);
    }
  }



  template <int dim>
  void InitialGeometry<dim>::check_overlaps(const Fillings &fillings, const double h) const
  {
    const double tolerance = touching * h;
    const auto check       = [&](const FluidBody<dim> &body, const Point<dim> &p, const std::string &name) {
      if (body.signed_distance(p) < -tolerance)
        throw InputError("Fluid body " + body.name() + " overlaps " + name + " at " + to_text(p) +
                               " m. Fluid and walls may touch, not overlap.");
    };

    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      for (const WallShape<dim> &wall : wall_shapes)
      {
        for (const Point<dim> &p : wall.samples(h))
          check(*bodies[b], p, "wall " + wall.name);
        if (wall.holds(fillings[b], touching * h))
          continue;
        for (const Point<dim> &p : fillings[b])
          if (wall.encloses(p, tolerance))
            throw InputError("Fluid body " + bodies[b]->name() + " overlaps wall " + wall.name + " at " +
                             to_text(p) + " m. Fluid and walls may touch, not overlap.");
      }
      for (unsigned int other = 0; other < bodies.size(); ++other)
        if (b != other)
          for (const Point<dim> &p : fillings[other])
            check(*bodies[b], p, "fluid body " + bodies[other]->name());
    }
  }



  template <int dim>
  void InitialGeometry<dim>::check_solids(const Fillings &fillings, const SolidContour<dim> &solids,
                                          const double h) const
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
    const auto is_deep_inside = [&](const Point<dim> &p) {
      return solids.is_inside(p) && !is_near(facets, p, tolerance);
    };
    for (const WallShape<dim> &wall : wall_shapes)
      for (const Point<dim> &p : wall.samples(h))
        check("Wall " + wall.name, p, is_deep_inside(p));
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      for (const Point<dim> &p : fillings[b])
        check("Fluid body " + bodies[b]->name(), p, is_deep_inside(p));
      for (const WallFacet<dim> &facet : solids.wall_facets())
        check("Fluid body " + bodies[b]->name(), facet.corners[0],
              bodies[b]->signed_distance(facet.corners[0]) < -tolerance);
    }
  }



  template <int dim>
  std::vector<Point<dim>> InitialGeometry<dim>::contacts(const WallShape<dim> &wall, const Fillings &fillings,
                                                         const SolidContour<dim> &solids,
                                                         const double h) const
  {
    const Walls<dim> facets(wall.facets());
    std::vector<Point<dim>> result;
    const auto add = [&](const std::vector<Point<dim>> &points) {
      for (const Point<dim> &p : points)
        if (is_near(facets, p, touching * h))
          result.push_back(p);
    };
    for (unsigned int b = 0; b < bodies.size(); ++b)
      add(dim == 2 ? bodies[b]->corners() : fillings[b]);

    std::vector<Point<dim>> of_solids;
    for (const WallFacet<dim> &facet : solids.wall_facets())
      if (std::all_of(facet.corners.begin(), facet.corners.end(),
                      [&](const Point<dim> &p) { return is_near(facets, p, touching * h); }))
        of_solids.insert(of_solids.end(), facet.corners.begin(), facet.corners.end());
    // In the plane, facets in a row along the wall share nodes: the ends of the row are in one only.
    for (const Point<dim> &p : of_solids)
      if (dim == 3 || std::count(of_solids.begin(), of_solids.end(), p) == 1)
        result.push_back(p);
    return result;
  }



  template <int dim>
  std::vector<bool> InitialGeometry<dim>::create(const MeshSize<dim> &h, const SolidContour<dim> &solids,
                                                 ParticleCloud<dim> &cloud, Walls<dim> &walls) const
  {
    check_mesh_scale(h.coarsest());
    check_body_sizes(h.coarsest());
    check_number_of_particles(h);
    Fillings fillings;
    for (const auto &body : bodies)
      fillings.push_back(body->fill(h));
    check_overlaps(fillings, h.coarsest());
    check_solids(fillings, solids, h.coarsest());

    const Walls<dim> solid_facets(solids.wall_facets());
    std::vector<WallFacet<dim>> facets;
    std::vector<Point<dim>> wall_points;
    for (const WallShape<dim> &wall : wall_shapes)
    {
      for (const WallFacet<dim> &facet : wall.facets())
        facets.push_back(facet);
      if (!wall.slip)
        for (const Point<dim> &p : wall.particles(contacts(wall, fillings, solids, h.coarsest()), h))
          if (!is_near(solid_facets, p, 0.1 * h(p)))
            wall_points.push_back(p);
    }
    walls = Walls<dim>(facets);

    // Two walls may share points, a fluid's contour may run along a wall: the first particle in a place stays, and a
    // wall particle in the place of a fluid particle is wet.
    std::vector<bool> wet(cloud.size(), false);
    PointSet<dim> places;
    for (const Point<dim> &p : cloud.position)
      places.insert(p);
    const auto add = [&](const Point<dim> &p, const ParticleKind kind, const double clearance) {
      const std::vector<unsigned int> near = places.near(p, clearance);
      if (kind == ParticleKind::fluid)
        for (const unsigned int i : near)
          wet[i] = true;
      if (!near.empty())
        return;
      cloud.append(p, kind, h(p));
      places.insert(p);
      wet.push_back(kind == ParticleKind::fluid);
    };
    for (const Point<dim> &p : wall_points)
      add(p, ParticleKind::wall, 0.1 * h(p));
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      for (unsigned int i = 0; i < cloud.size(); ++i)
        if (cloud.kind[i] != ParticleKind::fluid &&
            std::abs(bodies[b]->signed_distance(cloud.position[i])) < 0.1 * h(cloud.position[i]))
          wet[i] = true;
      for (const Point<dim> &p : fillings[b])
        add(p, ParticleKind::fluid, 0.3 * h(p));
    }
    if (has_fluid() && cloud.n_particles(ParticleKind::fluid) == 0)
      throw InputError("No fluid particle is left beside the walls: all lie within 0.3 mesh sizes of one.");
    return wet;
  }



  template class InitialGeometry<2>;
  template class InitialGeometry<3>;
} // namespace Lahar
