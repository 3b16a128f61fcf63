// SPDX-License-Identifier: GPL-3.0-or-later

// Test that a film of a fluid is torn where it is too thin for the mesh, and only there, that its particles belong to the
// fluid around them then, and that remeshing leaves no flat cells of it.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/remeshing/thin_films.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

/// A film of the second fluid between two layers of the first one, h = 1: particles of the interfaces below and above it
/// alternate, and its thickness grows from one end to the other.
struct FilmBetweenLayers
{
  static constexpr unsigned int n = 16;
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  Migration<2> migration{MPI_COMM_SELF};

  FilmBetweenLayers(const double thin, const double thick)
  {
    const auto row = [&](const double x, const double y, const double slope, const FluidSet fluids) {
      for (unsigned int k = 0; k < n; ++k)
        cloud.append(Point<2>(x + k, y + slope * (x + k)), ParticleKind::fluid, 1., fluids);
    };
    const double slope = (thick - thin) / n;
    row(0., 0., 0., 1U);            // the floor
    row(0., 1., 0., 3U);            // below the film
    row(0.5, 1. + thin, slope, 3U); // above it
    row(0.5, 2. + thin, slope, 1U);
    std::vector<Simplex<2>> cells;
    std::vector<unsigned int> fluids;
    for (const unsigned int lower : {0U, n, 2 * n})
      for (unsigned int k = 0; k + 1 < n; ++k)
      {
        const unsigned int a = lower + k, b = a + n;
        cells.push_back({{a, a + 1, b}});
        cells.push_back({{a + 1, b + 1, b}});
        fluids.insert(fluids.end(), 2, lower == n);
      }
    mesh.reinit(cloud, cells, fluids);
  }

  double height(const unsigned int cell) const
  {
    const auto x   = corners_of<2>(mesh.particle_cells()[cell], cloud.position);
    double longest = 0.;
    for (unsigned int k = 0; k < 3; ++k)
      longest = std::max(longest, x[k].distance(x[(k + 1) % 3]));
    return 2. * signed_volume<2>(x) / longest;
  }

  double area_of_film() const
  {
    return mesh.volumes(cloud, 2)[1];
  }
};

void test_tearing()
{
  FilmBetweenLayers film(0.05, 0.35);
  const FluidMesh<2> &mesh               = film.mesh;
  const std::vector<unsigned int> fluids = mesh.cell_fluids();
  const std::vector<Simplex<2>> cells    = mesh.particle_cells();
  tear_thin_films(film.migration, film.mesh, film.cloud);
  bool thin_ones_only = true, all_thin_ones = true;
  unsigned int n_torn = 0;
  for (unsigned int c = 0; c < cells.size(); ++c)
  {
    const bool is_torn = fluids[c] == 1 && mesh.fluid(c) == 0;
    thin_ones_only     = thin_ones_only && (fluids[c] == mesh.fluid(c) || is_torn) &&
                     (!is_torn || film.height(c) < 0.18);
    all_thin_ones = all_thin_ones && !(mesh.fluid(c) == 1 && film.height(c) < 0.17);
    n_torn += is_torn;
  }
  check("cells of a film that are thin go over to the other fluid", all_thin_ones && n_torn > 8);
  check("others do not", thin_ones_only && n_torn < 20 && film.area_of_film() > 1.);
  std::vector<FluidSet> around(film.cloud.size(), 0U);
  for (unsigned int c = 0; c < cells.size(); ++c)
    for (const unsigned int i : cells[c])
      around[i] |= fluid_set(mesh.fluid(c));
  check("particles belong to the fluids around them", film.cloud.part == around);

  FilmBetweenLayers thick(0.2, 0.5);
  const std::vector<unsigned int> before = thick.mesh.cell_fluids();
  tear_thin_films(thick.migration, thick.mesh, thick.cloud);
  check("a film that is thick enough stays", thick.mesh.cell_fluids() == before);
}

void test_remeshing()
{
  FilmBetweenLayers film(0.02, 0.04);
  Remesher<2> remesher;
  parse(remesher, "");
  remesher.set_number_of_fluids(2);
  remesher.remesh(film.cloud, Walls<2>(), {}, 1e-3, film.mesh, film.migration);
  double lowest = 1.;
  for (unsigned int c = 0; c < film.mesh.n_cells(); ++c)
    lowest = std::min(lowest, film.height(c));
  check("nothing is left of a film that is thin everywhere", film.area_of_film(), 0.);
  check("nor are its flat cells", lowest > 0.3);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_tearing();
  test_remeshing();
  return n_failed > 0;
}
