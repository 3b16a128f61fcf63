// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_structure.h>
#include <lahar/boundary/open_floor.h>
#include <lahar/boundary/wall_contact.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/remeshing/first_mesh_check.h>
#include <lahar/simulator/cost_estimate.h>
#include <lahar/simulator/simulator.h>
#include <lahar/utilities/ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Lahar
{
  namespace
  {
    template <int dim>
    std::string volume_unit()
    {
      return dim == 2 && !Symmetry::is_rotational() ? " m^2" : " m^3";
    }

    /// Particles that one round inserts and the next one removes would go on for ever.
    constexpr unsigned int most_first_rounds = 10;
  } // namespace



  template <int dim>
  void Simulator<dim>::initialize()
  {
    for (const std::string &text : solids.create(input.mesh_size, input.run.start_time,
                                                 input.geometry.has_fluid() || input.gravity.norm() > 0.))
      output.warn(text);
    region.particles.rank      = Utilities::MPI::this_mpi_process(communicator());
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator());
    solids.append_particles(input.mesh_size, input.surfaces.slick(), region.particles);
    const SolidContour<dim> contour(solids.mesh().contour(), region.particles, solids.unevenness());
    input.geometry.create(input.mesh_size, contour, region.particles, walls, communicator());
    if (input.geometry.any_boundary_moves())
      walls = input.geometry.walls_at(input.run.start_time); // to the last bit where a resumed run has them
    prm.enter_subsection("Linear solver");
    const bool solves_directly = prm.get("Type") == "direct";
    prm.leave_subsection();
    if (solves_directly && n_ranks > 1)
      output.warn(
        "Warning: 'Linear solver/Type' is 'direct', which several ranks do not make faster; 'iterative' is.");
    for (const std::string &text : input.geometry.warnings(input.mesh_size.coarsest()))
      output.warn(text);
    if (const std::string text = warn_of_open_floor(region.particles, obstacles(contour), input.gravity,
                                                    communicator());
        !text.empty())
      output.warn(text);
    // As if the solids had come with their velocities for a second.
    std::vector<Point<dim>> old_position = region.particles.position;
    for (unsigned int i = 0; i < solids.mesh().n_contour_nodes(); ++i)
      old_position[i] -= region.particles.velocity[i];
    WallContact<dim>(with_slick_solids(WallStep<dim>(walls), old_position, 1.)).initialize(region.particles);
    inlets.start(input.geometry.inflows(), walls, region.particles, communicator());
    outlets = input.geometry.outlets();
    on_all_ranks(communicator(), [&] { outlets.check_initial(region.particles); });
    outlets.check_levels(input.gravity, materials.n_fluids());
    outlets.start_forces(input.geometry.all_boundaries().size());
    on_all_ranks(communicator(), [&] { input.domain_limit.check_initial(prm, region.particles); });
    FluidStructure<dim>::prepare(materials, region.particles);
    migration.distribute(region.particles, region_distance(), solids.mesh().n_contour_nodes());
    create_first_mesh();
    FluidStructure<dim>::complete(region.mesh, materials, migration, region.particles);
    inlets.find_shares(walls, region.particles, region.mesh, communicator());
    inlets.start_step(region.particles, region.mesh, communicator(), input.run.start_time, 0.);
    inlets.carry(region.particles.position, region.particles); // they move from the start
    time = input.run.start_time;
    region.remeshing.arrives.assign(region.mesh.n_vertices(), false);
    account.begin(input.geometry.fluid_names(), fluid());
    output.initialize(snapshot());
    warn_of_coarse_mesh();
    checkpoint.remember_files();
  }



  template <int dim>
  void Simulator<dim>::create_first_mesh()
  {
    for (unsigned int n_rounds = 0; n_rounds <= most_first_rounds; ++n_rounds)
    {
      const SolidContour<dim> contour(solids.mesh().contour(), region.particles);
      if (n_rounds > 0 &&
          !remesher.adapt_first_particles(region.particles, obstacles(contour), region.mesh, migration))
        break;
      if (materials.n_fluids() > 1)
        input.geometry.put_on_interfaces(region.particles);
      try
      {
        remesher.create_mesh(region.particles, obstacles(contour), contour.facets_that_land(false),
                             input.geometry.region(), migration, region.mesh);
        if (materials.n_fluids() > 1)
          region.mesh.set_cell_fluids(input.geometry.cell_fluids(region.mesh, region.particles));
      }
      catch (const RunError &error)
      {
        throw InputError(std::string("Initial mesh: ") + error.what() + ".");
      }
      if (input.geometry.has_fluid() && count_on_ranks(region.mesh.n_cells()) == 0)
        throw InputError("The fluid has no cell at 'Mesh size' " + prm.get("Mesh size") +
                         ". Allowed: a mesh size well below the size of the fluid.");
      migrate();
    }
  }



  namespace
  {
    /// Below this many mesh sizes across fluid, gaps and solids of linear elements are too thin.
    constexpr double thin = 3.;
  } // namespace



  template <int dim>
  void Simulator<dim>::warn_of_coarse_mesh()
  {
    const std::string unit = volume_unit<dim>();
    const auto warn        = [&](const std::ostringstream &text) { output.warn("Warning: " + text.str()); };
    const double asked = input.geometry.fluid_volume(), difference = account.volume.initial_volume() - asked;
    if (std::abs(difference) > 0.01 * asked)
    {
      std::ostringstream text;
      text << "the first mesh has " << account.volume.initial_volume() << unit << " of fluid, and " << asked
           << unit << " are asked for (" << std::showpos << 100. * difference / asked
           << " %): 'Mesh size' is too coarse for the shape.";
      warn(text);
    }

    const SolidContour<dim> contour(solids.mesh().contour(), region.particles);
    const FirstMeshCheck<dim> check(region.particles, region.mesh, migration);
    if (const auto shared = check.between_two_sides(walls); shared.n > 0.)
    {
      std::ostringstream text;
      text
        << "fluid stands on both sides of a wall that is too thin for the mesh to part them, at " << shared.n
        << " particles, one at (" << shared.place
        << ") m: pressure and flow pass through it. Allowed: a wall with two sides, at least 0.2 mesh sizes apart.";
      warn(text);
    }
    if (const auto enclosed = check.enclosed(); enclosed.n > 0.)
    {
      std::ostringstream text;
      text
        << enclosed.n << " fluid particles, one at (" << enclosed.place
        << ") m, have no free surface: rigid walls close them in on all sides, as in a full tank or inside a rigid "
           "body, and their pressure is known up to a constant only.";
      warn(text);
    }
    if (const auto [ratio, place] = check.thinnest(obstacles(contour), thin); ratio < thin * (1. - 1e-6))
    {
      std::ostringstream text;
      text << "the fluid is " << ratio << " mesh sizes thick at (" << place << ") m, fewer than " << thin
           << " cells across.";
      warn(text);
    }
    // Quadratic elements bend right with one across (doc/theory/solids.md).
    if (!solids.empty() && solids.mesh().nodes_per_cell() == dim + 1)
    {
      const std::vector<WallFacet<dim>> &facets = contour.wall_facets();
      double size = std::numeric_limits<double>::max(); // of the elements across, no more than on the contour
      std::vector<std::string> owners;
      for (const WallFacet<dim> &facet : facets)
      {
        size = std::min(size, facet.corners[0].distance(facet.corners[1]));
        owners.push_back(std::to_string(owners.size()));
      }
      if (const auto part = NarrowGap<dim>::find(
            facets, owners, [&](const Point<dim> &p) { return !contour.is_inside(p); }, size, thin))
      {
        std::ostringstream text;
        text
          << "a solid is " << part->width << " m, " << part->ratio << " elements, thick at (" << part->place
          << ") m, fewer than " << thin
          << " across: with 'Solids/Degree' 1 it is too stiff in bending. Allowed: 2, or smaller elements.";
        warn(text);
      }
    }
    if (const auto gap = input.geometry.narrow_gap(input.mesh_size, contour, thin))
    {
      std::ostringstream text;
      text << "the gap between " << gap->owner << " and " << gap->other_owner << " is " << gap->width
           << " m, " << gap->ratio << " mesh sizes, wide at (" << gap->place << ") m, fewer than " << thin
           << " cells across: if fluid is to flow through it, it does not do so as it should.";
      warn(text);
    }
  }



  template <int dim>
  std::string Simulator<dim>::sizes() const
  {
    std::ostringstream text;
    const auto &vertices          = region.mesh.particles();
    const unsigned int n_vertices = count_on_ranks(
      std::count_if(vertices.begin(), vertices.end(),
                    [&](const unsigned int i) { return region.particles.is_own(i); }));
    const unsigned int n_fluid_cells = count_on_ranks(region.mesh.own_cells(region.particles).size());
    text << "Fluid particles  " << count_on_ranks(region.particles.n_particles(ParticleKind::fluid))
         << "\nWall particles   " << count_on_ranks(region.particles.n_particles(ParticleKind::wall))
         << "\nFluid cells      " << n_fluid_cells << "\nUnknowns         " << (dim + 1) * n_vertices
         << "\nFluid volume     " << account.volume.initial_volume() << volume_unit<dim>();
    if (!solids.empty())
      text << "\nSolid nodes      " << solids.mesh().n_nodes() << "\nSolid cells      "
           << solids.mesh().n_cells();
    constexpr double thick = 10.;
    if (const double ratio =
          FirstMeshCheck<dim>(region.particles, region.mesh, migration)
            .thinnest(obstacles(SolidContour<dim>(solids.mesh().contour(), region.particles)), thick)
            .first;
        n_fluid_cells > 0)
    {
      text << "\nThinnest part    ";
      if (ratio < thick)
        text << ratio << " mesh sizes across";
      else
        text << thick << " mesh sizes across or more";
    }
    text << '\n' << estimate_cost(dim, n_fluid_cells + solids.mesh().n_cells(), prm);
    for (const std::string &warning : output.warnings())
      text << '\n' << warning;
    return text.str();
  }



  template void Simulator<2>::initialize();
  template void Simulator<3>::initialize();
  template std::string Simulator<2>::sizes() const;
  template std::string Simulator<3>::sizes() const;
} // namespace Lahar
