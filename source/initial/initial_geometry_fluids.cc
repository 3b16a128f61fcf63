// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/wall_shape.h>
#include <lahar/initial/initial_geometry.h>
#include <lahar/material/newtonian.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/cell_fluid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Lahar
{
  namespace
  {
    /// Over h: as far are points inside a fluid from the contours of others.
    constexpr double interface_clearance = 0.6;

    /// Mesh sizes, or squares of them, that a wall may be large: it is looked at in so many places.
    constexpr double largest_wall = 1e7;
  } // namespace



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
                << ". Allowed: 'Largest number of particles', which is " << max_particles
                << ", of all fluids and boundaries.";
        throw InputError(message.str());
      }
    };
    for (const auto &body : bodies)
      check(body->estimate_size(h) + mesh_size.estimate_refinement(body->box(), dim),
            "fluid " + body->name());
    for (const WallShape<dim> &wall : wall_shapes)
    {
      if (wall.lands) // particles on its sharp edges at most, but its surface is looked at at this distance
      {
        if (const double n = wall.estimate_size(h); !(n <= largest_wall))
        {
          std::ostringstream message;
          message << "Parameter 'Mesh size' is " << h << " m, of which boundary " << wall.name << " is about "
                  << n << (dim == 2 ? " long" : " squared large") << ". Allowed: at most " << largest_wall
                  << ".";
          throw InputError(message.str());
        }
        double n = 0.;
        if (dim == 3 && wall.sticks)
          for (const WallFacet<dim> &facet : wall.facets())
            for (unsigned int c = 0; c < dim; ++c)
              n += std::max(0., facet.corners[c].distance(facet.corners[(c + 1) % dim]) / h - 1.);
        check(n, "boundary " + wall.name);
        continue;
      }
      std::vector<Point<dim>> corners;
      for (const WallFacet<dim> &facet : wall.facets())
        corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
      check(wall.estimate_size(h) + mesh_size.estimate_refinement(box_around(corners), dim - 1),
            "boundary " + wall.name);
    }
  }



  template <int dim>
  Materials InitialGeometry<dim>::materials() const
  {
    static const Newtonian water;
    if (fluids.empty())
      return Materials(water);
    std::vector<const FluidLaw *> laws;
    for (unsigned int n = 0; n < fluids.size(); ++n)
      if (material_of[n] == laws.size())
        laws.push_back(fluids[n].law.get());
    return Materials(laws);
  }



  template <int dim>
  std::vector<FluidLaw *> InitialGeometry<dim>::laws()
  {
    std::vector<FluidLaw *> result;
    for (unsigned int n = 0; n < fluids.size(); ++n)
      if (material_of[n] == result.size())
        result.push_back(fluids[n].law.get());
    return result;
  }



  template <int dim>
  std::vector<std::string> InitialGeometry<dim>::fluid_names() const
  {
    std::vector<std::string> names;
    for (unsigned int n = 0; n < fluids.size(); ++n)
      if (material_of[n] == names.size())
        names.push_back(fluids[n].name);
      else
        names[material_of[n]] += " and " + fluids[n].name;
    return names;
  }



  template <int dim>
  typename InitialGeometry<dim>::Fillings
  InitialGeometry<dim>::fill_bodies(const MeshSize<dim> &h, const MPI_Comm &communicator) const
  {
    Fillings result;
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      DividedPoints<dim> points = bodies[b]->fill(h, communicator);
      const auto crowds         = [&](const Point<dim> &point, const unsigned int other) {
        const double reach = interface_clearance * h(point);
        return material(other) != material(b) && bodies[other]->box().contains(point, reach) &&
               bodies[other]->signed_distance(point) < reach &&
               bodies[b]->signed_distance(point) < -2. * touching * h(point) - bodies[b]->roughness();
      };
      for (unsigned int other = 0; other < bodies.size() && n_materials() > 1; ++other)
        points.keep_if([&](const std::size_t i) { return !crowds(points.position[i], other); });
      result.push_back(std::move(points));
    }
    return result;
  }



  namespace
  {
    /// The way along which the distance from a body's contour grows near a point; of length one, or zero at ridges.
    template <int dim>
    Tensor<1, dim> outwards(const FluidBody<dim> &body, const Point<dim> &point, const double h)
    {
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const Tensor<1, dim> step = 0.01 * h * Point<dim>::unit_vector(d);
        result[d]                 = body.signed_distance(point + step) - body.signed_distance(point - step);
      }
      return result.norm() > 0. ? result / result.norm() : result;
    }

    /// Whether the way from a point near the contour of a body into it passes through a wall without particles.
    template <int dim>
    bool is_behind_wall(const FluidBody<dim> &body, const Point<dim> &point, const double h,
                        const Walls<dim> &walls)
    {
      const auto crossed = walls.crossed(point, point - 0.1 * h * outwards(body, point, h), 0., touching * h);
      return std::any_of(crossed.begin(), crossed.end(),
                         [&](const unsigned int facet) { return walls.facets()[facet].lands; });
    }
  } // namespace



  template <int dim>
  void InitialGeometry<dim>::mark_interfaces(const Walls<dim> &walls, ParticleCloud<dim> &cloud) const
  {
    for (unsigned int i = 0; i < cloud.size() && n_materials() > 1; ++i)
      if (cloud.kind[i] == ParticleKind::fluid)
        for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          const Point<dim> &point = cloud.position[i];
          const double reach      = 2. * touching * cloud.spacing[i] + bodies[b]->roughness();
          if ((cloud.part[i] & fluid_set(material(b))) == 0U && bodies[b]->box().contains(point, reach) &&
              bodies[b]->signed_distance(point) < reach &&
              !is_behind_wall(*bodies[b], point, cloud.spacing[i], walls))
            cloud.part[i] |= fluid_set(material(b));
        }
  }



  template <int dim>
  void InitialGeometry<dim>::put_on_interfaces(ParticleCloud<dim> &cloud) const
  {
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.kind[i] == ParticleKind::fluid && has_several(cloud.part[i]))
        for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          const double h = cloud.spacing[i], distance = bodies[b]->signed_distance(cloud.position[i]);
          if ((cloud.part[i] & fluid_set(material(b))) != 0U && std::abs(distance) < 0.5 * h &&
              std::abs(distance) > 2. * touching * h + bodies[b]->roughness())
            cloud.position[i] -= distance * outwards(*bodies[b], cloud.position[i], h);
        }
  }



  template <int dim>
  std::vector<unsigned int> InitialGeometry<dim>::cell_fluids(const FluidMesh<dim> &mesh,
                                                              const ParticleCloud<dim> &cloud) const
  {
    std::vector<unsigned int> result;
    for (const Simplex<dim> &cell : mesh.particle_cells())
      result.push_back(fluid_of_cell<dim>(cell, cloud, [&] {
        const Point<dim> centre = centroid<dim>(corners_of<dim>(cell, cloud.position));
        unsigned int nearest    = 0;
        double smallest         = std::numeric_limits<double>::max();
        for (unsigned int b = 0; b < bodies.size(); ++b)
          if (const double distance = bodies[b]->signed_distance(centre); distance < smallest)
          {
            smallest = distance;
            nearest  = material(b);
          }
        return std::make_optional(nearest);
      }));
    return result;
  }



  template Materials InitialGeometry<2>::materials() const;
  template Materials InitialGeometry<3>::materials() const;
  template std::vector<FluidLaw *> InitialGeometry<2>::laws();
  template std::vector<FluidLaw *> InitialGeometry<3>::laws();
  template std::vector<std::string> InitialGeometry<2>::fluid_names() const;
  template std::vector<std::string> InitialGeometry<3>::fluid_names() const;
  template InitialGeometry<2>::Fillings InitialGeometry<2>::fill_bodies(const MeshSize<2> &,
                                                                        const MPI_Comm &) const;
  template InitialGeometry<3>::Fillings InitialGeometry<3>::fill_bodies(const MeshSize<3> &,
                                                                        const MPI_Comm &) const;
  template void InitialGeometry<2>::mark_interfaces(const Walls<2> &, ParticleCloud<2> &) const;
  template void InitialGeometry<3>::mark_interfaces(const Walls<3> &, ParticleCloud<3> &) const;
  template void InitialGeometry<2>::put_on_interfaces(ParticleCloud<2> &) const;
  template std::vector<unsigned int> InitialGeometry<2>::cell_fluids(const FluidMesh<2> &,
                                                                     const ParticleCloud<2> &) const;
  template void InitialGeometry<3>::put_on_interfaces(ParticleCloud<3> &) const;
  template std::vector<unsigned int> InitialGeometry<3>::cell_fluids(const FluidMesh<3> &,
                                                                     const ParticleCloud<3> &) const;
  template void InitialGeometry<2>::check_number_of_particles(const MeshSize<2> &) const;
  template void InitialGeometry<3>::check_number_of_particles(const MeshSize<3> &) const;
} // namespace Lahar
