// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/geometry/packed_points.h>
#include <lahar/geometry/take_places.h>
#include <lahar/initial/contact_at_start.h>
#include <lahar/initial/initial_geometry.h>
#include <lahar/initial/seed_obstacles.h>
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
    Seeds seeds = place_seeds(h, solids, cloud, walls, communicator);

    const unsigned int n_first = seeds.position.size(), n = has_fluid() ? seeds.behind.back() : n_first,
                       n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (has_fluid() && n == n_first &&
        std::find(seeds.kind.begin(), seeds.kind.end(), ParticleKind::fluid) == seeds.kind.end())
      throw InputError("No fluid particle is left beside the walls: all lie within 0.3 mesh sizes of one.");

    const auto append = [&](const Point<dim> &p, const unsigned int number, const ParticleKind kind,
                            const unsigned int part) {
      cloud.append(p, kind, h(p), part);
      cloud.number.back() = number;
      if (kind == ParticleKind::fluid)
      {
        cloud.part.back()     = fluid_set(material(part));
        cloud.velocity.back() = fluids[fluid_of[part]].initial_velocity(p);
      }
    };
    for (unsigned int i = cloud.size(); i < n_first; ++i)
      if (first_owner(i, n, n_ranks) == cloud.rank)
        append(seeds.position[i], i, seeds.kind[i], seeds.part[i]);
    send<dim>(
      seeds.inside, [&](const std::size_t i) { return first_owner(seeds.inside.number[i], n, n_ranks); },
      communicator);
    for (std::size_t i = 0; i < seeds.inside.size(); ++i)
      append(seeds.inside.position[i], seeds.inside.number[i], ParticleKind::fluid,
             seeds.body(seeds.inside.number[i]));
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
    check_overlaps(fillings, h.coarsest(), communicator);
    check_common_faces(fillings, h.coarsest(), communicator);
    check_solids(fillings, solids, h.coarsest(), communicator);
    const auto wall_points              = create_walls(h, fillings, solids, walls, communicator);
    std::vector<WallFacet<dim>> covered = solids.wall_facets_that_land(false),
                                open    = solids.wall_facets_that_land(true);
    for (const WallFacet<dim> &facet : walls.facets())
      (facet.lands ? open : covered).push_back(facet);
    const SeedObstacles<dim> obstacles(bodies, h, covered, open);

    // The solids' particles, and then what may become one, in the order in which the places are taken.
    Seeds seeds{cloud.position, cloud.kind, cloud.part, {}, {}};
    // Two walls may share points; what they share with an inflow is theirs.
    for (const bool comes_in : {false, true})
      for (const auto &[p, boundary] : wall_points)
        if ((boundaries[boundary].inflow() != nullptr) == comes_in)
          seeds.append(p, ParticleKind::wall, boundary);
    // Corners come first: they hold the shape.
    for (unsigned int b = 0; b < bodies.size(); ++b)
      for (const Point<dim> &p : bodies[b]->corners())
        seeds.append(obstacles.place(p, b), ParticleKind::fluid, b);

    const PackedPoints<dim> places(seeds.position);
    std::vector<bool> stands(seeds.position.size(), false); // so far
    const auto is_free = [&](const Point<dim> &p, const unsigned int body, const double clearance) {
      return !obstacles.is_covered(p, body) &&
             !places.any_near(p, clearance * h(p), [&](const unsigned int i) {
               return stands[i] && (seeds.kind[i] == ParticleKind::fluid
                                      ? obstacles.blocks(seeds.position[i], seeds.part[i], p, body)
                                      : obstacles.blocks(seeds.position[i], p, body));
             });
    };
    for (unsigned int i = 0; i < stands.size(); ++i)
      if (i < cloud.size())
        stands[i] = seeds.kind[i] != ParticleKind::slick_solid;
      else if (seeds.kind[i] == ParticleKind::wall)
        stands[i] = !places.any_near(seeds.position[i], contact * h(seeds.position[i]),
                                     [&](const unsigned int other) { return stands[other]; });
      else
        stands[i] = is_free(seeds.position[i], seeds.part[i], contact);

    for (unsigned int b = 0, n = 0; b < bodies.size(); ++b)
    {
      for (std::size_t i = 0; i < fillings[b].size(); ++i)
        seeds.inside.append(obstacles.place(fillings[b].position[i], b), n + fillings[b].number[i]);
      n += end_of_numbers(fillings[b], communicator);
      seeds.behind.push_back(n);
      fillings[b] = {};
    }
    divide(seeds.inside, communicator);
    std::vector<bool> inside;
    for (std::size_t i = 0; i < seeds.inside.size(); ++i)
      inside.push_back(
        is_free(seeds.inside.position[i], seeds.body(seeds.inside.number[i]), inside_clearance));
    inside = take_places<dim>(
      seeds.inside, inside, [&](const Point<dim> &p) { return inside_clearance * h(p); },
      [&](const Point<dim> &p, const unsigned int number, const Point<dim> &other,
          const unsigned int other_number) {
        return obstacles.blocks(other, seeds.body(other_number), p, seeds.body(number));
      },
      communicator);
    seeds.keep(stands, inside, cloud.size(), communicator);
    return seeds;
  }



  template <int dim>
  void InitialGeometry<dim>::Seeds::keep(const std::vector<bool> &stands,
                                         const std::vector<bool> &stands_inside, const unsigned int n_solid,
                                         const MPI_Comm &communicator)
  {
    unsigned int n = n_solid;
    for (unsigned int i = n_solid; i < stands.size(); ++i)
      if (stands[i])
      {
        position[n] = position[i];
        kind[n]     = kind[i];
        part[n++]   = part[i];
      }
    position.resize(n);
    kind.resize(n);
    part.resize(n);

    inside.keep_if([&](const std::size_t i) { return stands_inside[i]; });
    std::vector<unsigned int> n_of_body(behind.size(), 0);
    for (const unsigned int number : inside.number)
      ++n_of_body[body(number)];
    Utilities::MPI::sum(n_of_body, communicator, n_of_body);
    renumber(inside, n, communicator);
    for (unsigned int b = 0; b < behind.size(); ++b)
      behind[b] = n += n_of_body[b];
  }



  template void InitialGeometry<2>::create(const MeshSize<2> &, const SolidContour<2> &, ParticleCloud<2> &,
                                           Walls<2> &, const MPI_Comm &) const;
  template void InitialGeometry<3>::create(const MeshSize<3> &, const SolidContour<3> &, ParticleCloud<3> &,
                                           Walls<3> &, const MPI_Comm &) const;
} // namespace Lahar
