// SPDX-License-Identifier: GPL-3.0-or-later

// Test that particles outside the domain are dropped with their cells, and nothing else is.

#include <lahar/remeshing/domain_limit.h>
#include <lahar/remeshing/remesher.h>

#include "plain_region.h"

using namespace Tests;

/// A lattice of 5^dim fluid particles on [0,4]^dim, less those of its top layer, which are wall particles.
template <int dim>
void test_lattice(const std::string &box, const unsigned int n_expected, const double volume_expected)
{
  ParticleCloud<dim> cloud;
  for (unsigned int i = 0; i < std::pow(5, dim); ++i)
  {
    Point<dim> p;
    for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 5)
      p[d] = rest % 5;
    cloud.append(p, p[dim - 1] > 3.5 ? ParticleKind::wall : ParticleKind::fluid, 1.);
    cloud.pressure[i] = p[0];
  }
  Remesher<dim> remesher;
  parse(remesher, "");
  FluidMesh<dim> mesh;
  const Walls<dim> no_walls;
  remesher.create_mesh(cloud, no_walls, {}, plain_region<dim>(no_walls), mesh);
  const unsigned int n_before = cloud.size();
  const std::string name      = std::to_string(dim) + "D, box '" + box + "': ";
  check(name + "the whole volume before", mesh.volume(cloud) - std::pow(4., dim), 1e-12);

  DomainLimit<dim> limit;
  parse(limit, "subsection Remeshing\n set Domain = " + box + "\nend\n");
  check(name + "number of dropped particles", limit.drop_outside(cloud, mesh) == n_expected);
  check(name + "they are gone", cloud.size() == n_before - n_expected);
  check(name + "their cells are gone", mesh.volume(cloud) - volume_expected, 1e-12);
  bool values_follow = true;
  for (unsigned int i = 0; i < cloud.size(); ++i)
    values_follow = values_follow && cloud.pressure[i] == cloud.position[i][0];
  check(name + "the others keep their values", values_follow);
  bool vertices_follow = true;
  if (mesh.n_cells() > 0) // deal.II has no iterators for an empty triangulation
    for (const auto &cell : mesh.dof_handler().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        vertices_follow = vertices_follow &&
                          cell->vertex(v) == cloud.position[mesh.particle(cell->vertex_index(v))];
  check(name + "the triangulation follows", vertices_follow);
  check(name + "a second call drops nothing", limit.drop_outside(cloud, mesh) == 0);
}

int main()
{
  test_lattice<2>("", 0, 16.);
  test_lattice<2>("-1, -1 : 5, 5", 0, 16.);
  test_lattice<2>("-1, -1 : 2.5, 5", 8, 8.); // x = 3, 4 below the wall; with them all cells beyond x = 2
  test_lattice<2>("-1, 0.5 : 5, 1", 15, 0.); // y = 0, 2, 3
  test_lattice<3>("-1, -1, -1 : 5, 5, 5", 0, 64.);
  test_lattice<3>("-1, -1, 0.5 : 5, 5, 5", 25, 48.); // z = 0
  return n_failed;
}
