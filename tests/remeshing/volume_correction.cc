// SPDX-License-Identifier: GPL-3.0-or-later

// Test that remeshing keeps the volume of a block whose particles are disturbed, with the plain alpha shape, which
// changes it most, in two and three dimensions; and that it moves no more than it must, nor for what the mesh and volumes
// outside of it, as the layers of an inflow, hand to each other.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/remesher.h>

#include "plain_region.h"

using namespace Tests;

template <int dim>
struct Block
{
  ParticleCloud<dim> cloud;
  Walls<dim> walls;
  FluidMesh<dim> mesh;
  Remesher<dim> remesher;

  /// n^dim particles of fluid at the distance 1, slightly disturbed, without walls.
  Block(const unsigned int n, const std::string &rule, const std::string &keep_volume)
  {
    parse(remesher, "subsection Remeshing\n set Keep volume = " + keep_volume +
                      "\n subsection Alpha shape\n set Rule = " + rule +
                      "\n end\n subsection Particle spacing\n set Shortest edge = 0\n end\nend\n");
    Random random;
    for (unsigned int i = 0; i < std::pow(n, dim); ++i)
    {
      Point<dim> p;
      for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n)
        p[d] = rest % n;
      cloud.append(p + 0.05 * random.vector<dim>(), ParticleKind::fluid, 1.);
    }
    remesher.create_mesh(cloud, walls, {}, plain_region<dim>(walls), mesh);
  }

  /// Disturb the particles and remesh. @return its relative volume change.
  double remesh_after_motion(double &largest_shift)
  {
    Random random;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      cloud.position[i] += (dim == 2 ? 0.35 : 0.2) * random.vector<dim>();
    mesh.move(cloud);
    const double before                  = mesh.volume(cloud);
    const std::vector<Point<dim>> places = cloud.position;
    remesher.remesh(cloud, walls, {}, 1e-3, mesh);
    largest_shift = 0.;
    if (cloud.size() == places.size())
      for (unsigned int i = 0; i < cloud.size(); ++i)
        largest_shift = std::max(largest_shift, cloud.position[i].distance(places[i]));
    return mesh.volume(cloud) / before - 1.;
  }
};

template <int dim>
void test_disturbed(const unsigned int n)
{
  const std::string name = std::to_string(dim) + "D: ";
  double shift;
  const double free_change = Block<dim>(n, "plain", "false").remesh_after_motion(shift);
  check(name + "without correction the volume changes", std::abs(free_change) > 2e-3);
  check(name + "and no particle moves", shift, 0.);
  const double change = Block<dim>(n, "plain", "true").remesh_after_motion(shift);
  check(name + "with it, a twentieth of that is left", change, 0.05 * std::abs(free_change));
  check(name + "no particle moves by more than a tenth of the spacing", shift <= 0.1 + 1e-12);
}

/// A block inside which nothing of the surface changes.
template <int dim>
void test_inside()
{
  const std::string name = std::to_string(dim) + "D: ";
  Block<dim> block(7, "advected", "true");
  for (unsigned int i = 0; i < 10; ++i) // until all flat cells on the surface are taken in
    block.remesher.remesh(block.cloud, block.walls, {}, 1e-3, block.mesh);
  // The middle particle moves far, the others do not: only inner cells are new.
  const unsigned int middle = (block.cloud.size() - 1) / 2;
  block.cloud.position[middle] += (dim == 2 ? 0.6 : 0.5) *
                                  Tensor<1, dim>(block.cloud.position[1] - block.cloud.position[0]);
  block.mesh.move(block.cloud);
  const std::vector<Point<dim>> places = block.cloud.position;
  const auto report = block.remesher.remesh(block.cloud, block.walls, {}, 1e-3, block.mesh);
  check(name + "a remeshing of the inside", report.changed);
  double shift = 0.;
  for (unsigned int i = 0; i < places.size(); ++i)
    shift = std::max(shift, places[i].distance(block.cloud.position[i]));
  check(name + "moves no particle", shift, 1e-6); // cells that are too flat are none
}

/// What the mesh loses or gains, a particle holds or gives outside of it: nothing is to be taken back.
template <int dim>
void test_outside(const unsigned int n)
{
  Block<dim> block(n, "plain", "true");
  block.remesher.set_outside_volumes([](const ParticleCloud<dim> &cloud, const FluidMesh<dim> &mesh) {
    return std::map<std::uint64_t, double>{{cloud.number[0], 1e3 - mesh.volume(cloud)}};
  });
  double shift;
  const double change    = block.remesh_after_motion(shift);
  const std::string name = std::to_string(dim) + "D: ";
  check(name + "with a volume outside the mesh changes", std::abs(change) > 2e-3);
  check(name + "but no particle moves for what passes between the two", shift, 0.);
  // Of 1e-3 each that the change of the mesh would be.
  check(name + "and none owes anything",
        *std::max_element(block.cloud.owed_volume.begin(), block.cloud.owed_volume.end()), 1e-8);
}

int main()
{
  test_disturbed<2>(12);
  test_disturbed<3>(8);
  test_outside<2>(12);
  test_outside<3>(8);
  test_inside<2>();
  test_inside<3>();
  return n_failed;
}
