// SPDX-License-Identifier: GPL-3.0-or-later

// Test thin walls in space with fluid on both sides: without thickness and of a tenth of the mesh size, each side has
// the cells that it has without the other one, wherever that slides to; round the rim of a wall there is no hole.

#include <lahar/boundary/wall_contact.h>
#include <lahar/remeshing/remesher.h>

#include <algorithm>

#include "../tests.h"

using namespace Tests;

constexpr double h       = 0.1;
constexpr unsigned int m = 3, n = 5;

Remesher<3> remesher()
{
  Remesher<3> result;
  parse(result, "subsection Remeshing\n set Keep volume = false\n subsection Particle spacing\n"
                "  set Shortest edge = 0\n  set Longest edge = 10\n end\nend\n");
  return result;
}

/// An upright wall at @p x, from far below up to the height @p top.
std::vector<WallFacet<3>> upright(const double x, const double top)
{
  const std::array<Point<3>, 4> c = {{{x, -1., -1.}, {x, 2., -1.}, {x, 2., top}, {x, -1., top}}};
  return {{{{c[0], c[1], c[2]}}, true}, {{{c[0], c[2], c[3]}}, true}};
}

/// A block of m by n by n mesh sizes with random particles that begins at @p x and extends to that @p side, its first
/// layer up to the height @p top only.
void add_block(const double x, const int side, const double top, Random &random, ParticleCloud<3> &cloud)
{
  const double jitter = 0.25 * h;
  for (unsigned int i = 0; i <= m; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int k = 0; k <= n; ++k)
      {
        const Tensor<1, 3> shift = jitter * random.vector<3>();
        Point<3> p(x + side * (i * h), j * h, k * h);
        p[0] += (i > 0 && i < m) ? shift[0] : 0.;
        p[1] += (j > 0 && j < n) ? shift[1] : 0.;
        p[2] += (k > 0 && k < n && i > 0) ? shift[2] : 0.;
        if (i > 0 || p[2] < top)
          cloud.append(p, ParticleKind::fluid, h);
      }
}

using Cells = std::vector<std::array<Point<3>, 4>>;

/// The corners of all cells whose first corner has x on that side, sorted.
Cells cells_of_side(const FluidMesh<3> &mesh, const ParticleCloud<3> &cloud, const int side)
{
  const auto before = [](const Point<3> &a, const Point<3> &b) {
    return std::lexicographical_compare(a.begin_raw(), a.end_raw(), b.begin_raw(), b.end_raw());
  };
  Cells result;
  for (const Simplex<3> &cell : mesh.particle_cells())
    if (side * cloud.position[cell[0]][0] > 0.)
    {
      std::array<Point<3>, 4> corners;
      for (unsigned int c = 0; c < 4; ++c)
        corners[c] = cloud.position[cell[c]];
      std::sort(corners.begin(), corners.end(), before);
      result.push_back(corners);
    }
  std::sort(result.begin(), result.end(), [&](const auto &a, const auto &b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
  });
  return result;
}

bool all(const Simplex<3> &, const ParticleCloud<3> &)
{
  return true;
}

void test_sides(const double thickness)
{
  const std::string name           = thickness > 0. ? "thin wall: " : "no thickness: ";
  const double x                   = 0.5 * thickness + 0.01 * contact_offset * h;
  std::vector<WallFacet<3>> facets = upright(-0.5 * thickness, 2.);
  if (thickness > 0.)
    for (const WallFacet<3> &facet : upright(0.5 * thickness, 2.))
      facets.push_back(facet);
  const Walls<3> walls(facets);
  const WallStep<3> standing(walls);
  const WallContact<3> contact(standing);
  Random random;
  ParticleCloud<3> cloud;
  add_block(-x, -1, 1., random, cloud);
  const unsigned int n_left = cloud.size();
  add_block(x, 1, 1., random, cloud);
  contact.initialize(cloud);

  FluidMesh<3> mesh;
  remesher().create_mesh(cloud, walls, {}, all, mesh);
  const double volume = 2. * m * n * n * h * h * h;
  check(name + "the mesh has the volume of both blocks", mesh.volume(cloud) / volume - 1., 1e-7);
  const auto is_on_one_side = [&](const Simplex<3> &cell) {
    return std::all_of(cell.begin(), cell.end(),
                       [&](const unsigned int i) { return (i < n_left) == (cell[0] < n_left); });
  };
  check(name + "no cell is on both sides",
        std::all_of(mesh.particle_cells().begin(), mesh.particle_cells().end(), is_on_one_side));
  std::vector<bool> is_right(cloud.size(), true);
  std::fill(is_right.begin(), is_right.begin() + n_left, false);
  ParticleCloud<3> left = cloud;
  left.remove(is_right);
  FluidMesh<3> left_mesh;
  remesher().create_mesh(left, walls, {}, all, left_mesh);
  check(name + "one side has the cells that it has alone",
        cells_of_side(mesh, cloud, -1) == cells_of_side(left_mesh, left, -1));

  // The other side slides along.
  const Cells before = cells_of_side(mesh, cloud, -1);
  for (unsigned int i = n_left; i < cloud.size(); ++i)
    cloud.position[i] += Point<3>(0., 0.37 * h, 0.21 * h);
  remesher().remesh(cloud, walls, {}, 1e-3, mesh);
  check(name + "its cells stay where the other side slides", cells_of_side(mesh, cloud, -1) == before);
  check(name + "the volume stays", mesh.volume(cloud) / volume - 1., 1e-7);
}

void test_rim()
{
  // Fluid on both sides of the wall and above it; the rim carries particles.
  const double top = 3. * h;
  const Walls<3> walls(upright(0., top));
  const WallStep<3> standing(walls);
  const WallContact<3> contact(standing);
  Random random;
  ParticleCloud<3> cloud;
  add_block(-0.01 * contact_offset * h, -1, top - 0.5 * h, random, cloud);
  const unsigned int n_left = cloud.size();
  add_block(0.01 * contact_offset * h, 1, top - 0.5 * h, random, cloud);
  for (unsigned int k = 3; k <= n; ++k)
    for (unsigned int j = 0; j <= n; ++j)
      cloud.append({0., j * h, k * h}, k == 3 ? ParticleKind::wall : ParticleKind::fluid, h);
  contact.initialize(cloud);
  FluidMesh<3> mesh;
  remesher().create_mesh(cloud, walls, {}, all, mesh);
  check("rim: the mesh has the volume of the fluid", mesh.volume(cloud) / (2. * m * n * n * h * h * h) - 1.,
        1e-2);
  unsigned int n_through = 0;
  for (const Simplex<3> &cell : mesh.particle_cells())
    for (const unsigned int i : cell)
      for (const unsigned int j : cell)
        if (i < n_left && j >= n_left && j < 2 * n_left)
          n_through += walls.crossed(cloud.position[i], cloud.position[j], 0., 0.).size();
  check("rim: no cell passes through the wall", n_through == 0);
}

int main()
{
  test_sides(0.);
  test_sides(0.1 * h);
  test_rim();
  return n_failed;
}
