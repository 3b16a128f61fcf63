// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/packed_points.h>
#include <lahar/initial/contact_at_start.h>
#include <lahar/initial/initial_geometry.h>
#include <lahar/particles/first_owner.h>
#include <lahar/particles/fluid_set.h>

#include <algorithm>

namespace Lahar
{
  namespace
  {
    /// A point inside a body is no particle where one stands nearer than this times h.
    constexpr double inside_clearance = 0.3;
  } // namespace



  template <int dim>
  void InitialGeometry<dim>::create(const MeshSize<dim> &h, const SolidContour<dim> &solids,
                                    ParticleCloud<dim> &cloud, Walls<dim> &walls,
                                    const MPI_Comm &communicator) const
  {
    for (const Fluid<dim> &fluid : fluids)
      fluid.shape->check_scale(h.coarsest());
    check_body_sizes(h.coarsest());
    check_number_of_particles(h);
    check_inflows(h.coarsest());
    const Seeds seeds = place_seeds(h, solids, cloud, walls, communicator);
    if (has_fluid() &&
        std::find(seeds.kind.begin(), seeds.kind.end(), ParticleKind::fluid) == seeds.kind.end())
      throw InputError("No fluid particle is left beside the walls: all lie within 0.3 mesh sizes of one.");

    const std::size_t n_shared = cloud.size(), n = seeds.position.size();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const auto is_here = [&](const std::size_t i) { return first_owner(i, n, n_ranks) == cloud.rank; };
    for (std::size_t i = n_shared; i < n; ++i)
      if (is_here(i))
      {
        const Point<dim> &p = seeds.position[i];
        cloud.append(p, seeds.kind[i], h(p), seeds.part[i]);
        cloud.number.back() = i;
        if (seeds.kind[i] == ParticleKind::fluid)
        {
          cloud.part.back()     = fluid_set(material(seeds.part[i]));
          cloud.velocity.back() = fluids[fluid_of[seeds.part[i]]].initial_velocity(p);
        }
      }
    cloud.next_number                    = n;
    std::vector<WallFacet<dim>> surfaces = solids.wall_facets_that_land(true);
    surfaces.insert(surfaces.end(), walls.facets().begin(), walls.facets().end());
    mark_interfaces(Walls<dim>(surfaces), cloud);
  }



  template <int dim>
  typename InitialGeometry<dim>::Seeds
  InitialGeometry<dim>::place_seeds(const MeshSize<dim> &h, const SolidContour<dim> &solids,
                                    const ParticleCloud<dim> &cloud, Walls<dim> &walls,
                                    const MPI_Comm &communicator) const
  {
    Fillings fillings = fill_bodies(h, communicator);
    check_overlaps(fillings, h.coarsest());
    check_common_faces(fillings, h.coarsest());
    check_solids(fillings, solids, h.coarsest());
    const auto wall_points              = create_walls(h, fillings, solids, walls);
    std::vector<WallFacet<dim>> covered = solids.wall_facets_that_land(false),
                                open    = solids.wall_facets_that_land(true);
    for (const WallFacet<dim> &facet : walls.facets())
      (facet.lands ? open : covered).push_back(facet);
    const Walls<dim> covered_facets(covered), open_facets(open);

    // The solids' particles, and then what may become one, in the order in which the places are taken.
    Seeds seeds{cloud.position, cloud.kind, cloud.part};
    std::size_t n = cloud.size() + wall_points.size();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      n += bodies[b]->corners().size() + fillings[b].size();
    seeds.position.reserve(n);
    seeds.kind.reserve(n);
    seeds.part.reserve(n);
    const auto append = [&](const Point<dim> &p, const ParticleKind kind, const unsigned int part) {
      seeds.position.push_back(p);
      seeds.kind.push_back(kind);
      seeds.part.push_back(part);
    };
    const auto append_fluid = [&](const Point<dim> &p, const unsigned int b) {
      append(bodies[b]->onto_walls(p, open_facets, h(p), contact * h(p) + bodies[b]->roughness()),
             ParticleKind::fluid, b);
    };
    // Two walls may share points; what they share with an inflow is theirs.
    for (const bool comes_in : {false, true})
      for (const auto &[p, boundary] : wall_points)
        if ((boundaries[boundary].inflow() != nullptr) == comes_in)
          append(p, ParticleKind::wall, boundary);
    // Corners come first: they hold the shape.
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const Point<dim> &p : bodies[b]->corners())
        append_fluid(p, b);
    const std::size_t first_inside = seeds.position.size();
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      for (const Point<dim> &p : fillings[b])
        append_fluid(p, b);
      std::vector<Point<dim>>().swap(fillings[b]);
    }

    const PackedPoints<dim> places(seeds.position);
    std::vector<bool> stands(n, false); // so far
    const auto is_taken = [&](const std::size_t i) {
      const Point<dim> &p = seeds.position[i];
      if (seeds.kind[i] == ParticleKind::wall)
        return places.any_near(p, contact * h(p), [&](const unsigned int other) { return stands[other]; });
      // By a particle of the body's region; of points of the body's own, whose two sides may come near to each other,
      // by one that stands very near.
      const unsigned int b       = seeds.part[i];
      const FluidBody<dim> &body = *bodies[b];
      if (is_near(covered_facets, p, contact * h(p) + body.roughness()))
        return true;
      const double clearance = i < first_inside ? contact : inside_clearance;
      return places.any_near(p, clearance * h(p), [&](const unsigned int other) {
        const Point<dim> &q = seeds.position[other];
        if (!stands[other] || !open_facets.crossed(q, p, 0., touching * h(p)).empty())
          return false;
        const bool is_fluid = seeds.kind[other] == ParticleKind::fluid;
        return is_fluid && seeds.part[other] == b
                 ? q.distance(p) < contact * h(p)
                 : body.signed_distance(q) < (is_fluid ? touching : contact) * h(p) + body.roughness();
      });
    };
    for (std::size_t i = 0; i < n; ++i)
      stands[i] = i < cloud.size() ? seeds.kind[i] != ParticleKind::slick_solid : !is_taken(i);
    std::size_t n_seeds = cloud.size();
    for (std::size_t i = cloud.size(); i < n; ++i)
      if (stands[i])
      {
        seeds.position[n_seeds] = seeds.position[i];
        seeds.kind[n_seeds]     = seeds.kind[i];
        seeds.part[n_seeds++]   = seeds.part[i];
      }
    seeds.position.resize(n_seeds);
    seeds.kind.resize(n_seeds);
    seeds.part.resize(n_seeds);
    return seeds;
  }



  template void InitialGeometry<2>::create(const MeshSize<2> &, const SolidContour<2> &, ParticleCloud<2> &,
                                           Walls<2> &, const MPI_Comm &) const;
  template void InitialGeometry<3>::create(const MeshSize<3> &, const SolidContour<3> &, ParticleCloud<3> &,
                                           Walls<3> &, const MPI_Comm &) const;
} // namespace Lahar
