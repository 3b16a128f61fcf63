// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_tests_initial_case_h
#define lahar_tests_initial_case_h

#include <lahar/geometry/initial_geometry.h>
#include <lahar/remeshing/remesher.h>

#include "../tests.h"

namespace Tests
{
  /// Particles, walls and first mesh of a geometry, given by the entries of subsection "Geometry".
  template <int dim>
  struct InitialCase
  {
    ParticleCloud<dim> cloud;
    Walls<dim> walls;
    FluidMesh<dim> mesh;

    InitialCase(const Entries &entries, const double h, const MPI_Comm &communicator = MPI_COMM_SELF)
    {
      Parameters prm;
      InitialGeometry<dim>::declare_parameters(prm);
      prm.enter_subsection("Geometry");
      for (const auto &[entry, value] : entries)
        prm.set(entry, value);
      prm.leave_subsection();
      InitialGeometry<dim> geometry;
      geometry.parse_parameters(prm, false);
      geometry.create(h, SolidContour<dim>({}, cloud), cloud, walls);
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
  void test_ranks(const std::string &name, const Entries &entries, const double h)
  {
    const InitialCase<dim> whole(entries, h), part(entries, h, MPI_COMM_WORLD);
    const auto sum = [](const auto value) { return Utilities::MPI::sum(value, MPI_COMM_WORLD); };
    bool same      = true;
    for (const ParticleKind kind : {ParticleKind::fluid, ParticleKind::wall})
      same = same && sum(part.cloud.n_particles(kind)) == whole.cloud.n_particles(kind);
    check(name + " on ranks: particles", same);
    check(name + " on ranks: cells", sum(part.mesh.own_cells(part.cloud).size()) == whole.mesh.n_cells());
    // the ranks' sums are in another order
    check(name + " on ranks: volume", sum(part.mesh.volume(part.cloud)) / whole.mesh.volume(whole.cloud) - 1.,
          1e-12);
  }
} // namespace Tests

#endif
