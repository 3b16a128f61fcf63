// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_initial_case_h
#define lahar_tests_initial_case_h

#include <lahar/initial/initial_geometry.h>
#include <lahar/remeshing/remesher.h>

#include "../tests.h"

namespace Tests
{
  /// A fluid or a boundary of a case.
  struct Part
  {
    std::string kind; ///< "Fluids" or "Boundaries"
    std::string name;
    std::string shape;
    Entries of_shape;     ///< the entries in the subsection of the shape
    Entries further = {}; ///< those beside it
  };

  inline Part fluid_of(const std::string &shape, const Entries &of_shape, const std::string &name = "fluid")
  {
    return {"Fluids", name, shape, of_shape};
  }

  inline Part boxes(const std::string &corners)
  {
    return fluid_of("box", {{"Corners", corners}});
  }

  inline Part polygons(const std::string &corners)
  {
    return fluid_of("polygon", {{"Corners", corners}});
  }

  inline Part boundary_of(const std::string &shape, const Entries &of_shape,
                          const std::string &law = "wall particles", const std::string &name = "walls")
  {
    return {"Boundaries", name, shape, of_shape, {{"Law", law}}};
  }

  /// Walls in the plane.
  inline Part lines(const std::string &points, const std::string &law = "wall particles")
  {
    return boundary_of("polyline", {{"Points", points}}, law);
  }

  /// Walls in space.
  inline Part planes(const std::string &corners, const std::string &law = "wall particles")
  {
    return boundary_of("polygon", {{"Corners", corners}}, law);
  }

  /// The shape "mesh" of groups of a gmsh file.
  inline Entries mesh_of(const std::string &file, const std::string &groups)
  {
    return {{"File", file}, {"Groups", groups}};
  }

  using Parts = std::vector<Part>;

  template <int dim>
  InitialGeometry<dim> make_geometry(const Parts &parts)
  {
    CaseStructure structure;
    for (const Part &part : parts)
      (part.kind == "Fluids" ? structure.fluids : structure.boundaries).push_back(part.name);
    Parameters prm;
    InitialGeometry<dim>::declare_parameters(prm, structure);
    for (const Part &part : parts)
    {
      prm.enter_subsection(part.kind);
      prm.enter_subsection(part.name);
      prm.set("Shape", part.shape);
      for (const auto &[entry, value] : part.further)
        prm.set(entry, value);
      prm.enter_subsection(part.shape);
      for (const auto &[entry, value] : part.of_shape)
        prm.set(entry, value);
      for (unsigned int i = 0; i < 3; ++i)
        prm.leave_subsection();
    }
    InitialGeometry<dim> geometry;
    geometry.parse_parameters(prm, structure);
    return geometry;
  }

  /// Particles, walls and first mesh of a geometry.
  template <int dim>
  struct InitialCase
  {
    ParticleCloud<dim> cloud;
    Walls<dim> walls;
    FluidMesh<dim> mesh;

    InitialCase(const Parts &parts, const double h, const MPI_Comm &communicator = MPI_COMM_SELF)
    {
      const InitialGeometry<dim> geometry = make_geometry<dim>(parts);
      cloud.rank                          = Utilities::MPI::this_mpi_process(communicator);
      geometry.create(h, SolidContour<dim>({}, cloud), cloud, walls, communicator);
      Remesher<dim> remesher;
      parse(remesher);
      Migration<dim> migration(communicator);
      migration.distribute(cloud, remesher.region_distance(cloud, mesh, 0., communicator), 0);
      remesher.create_mesh(cloud, walls, {}, geometry.region(), migration, mesh);
      migration.migrate(cloud, mesh, remesher.region_distance(cloud, mesh, 0., communicator), 0);
    }
  };

  /// Several ranks have the particles, the cells and the volume of one.
  template <int dim>
  void test_ranks(const std::string &name, const Parts &parts, const double h)
  {
    const InitialCase<dim> whole(parts, h), part(parts, h, MPI_COMM_WORLD);
    const auto sum = [](const auto value) { return Utilities::MPI::sum(value, MPI_COMM_WORLD); };
    bool same      = true;
    for (const ParticleKind kind : {ParticleKind::fluid, ParticleKind::wall})
      same = same && sum(part.cloud.n_particles(kind)) == whole.cloud.n_particles(kind);
    check(name + " on ranks: particles", same);
    for (unsigned int i = 0; i < part.cloud.size(); ++i)
      same = same && part.cloud.position[i] == whole.cloud.position[part.cloud.number[i]];
    check(name + " on ranks: to the last bit, in the same order", same);
    check(name + " on ranks: cells", sum(part.mesh.own_cells(part.cloud).size()) == whole.mesh.n_cells());
    // the ranks' sums are in another order
    check(name + " on ranks: volume", sum(part.mesh.volume(part.cloud)) / whole.mesh.volume(whole.cloud) - 1.,
          1e-12);
  }
} // namespace Tests

#endif
