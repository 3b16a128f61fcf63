// SPDX-License-Identifier: GPL-3.0-or-later

// Test which simplices become fluid: hand-made clouds with a hole, a neck, a drop at a wall, slivers and degenerate
// points, the plain and the advected rule, dry walls, thin walls, 3D; and the Delaunay triangulation of lattices.

#include <deal.II/base/utilities.h>

#include <lahar/geometry/polygon.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/remesher.h>

#include "plain_region.h"

#include <limits>

using namespace Tests;

constexpr double h = 0.1;

template <int dim>
Remesher<dim> remesher(const std::string &rule)
{
  // The rules change volumes; here that shows what they did.
  Remesher<dim> result;
  parse(result, "subsection Remeshing\n set Keep volume = false\n subsection Alpha shape\n  set Rule = " +
                  rule + "\n end\nend\n");
  return result;
}

void fill(ParticleCloud<2> &cloud, const Polygon &polygon)
{
  for (const Point<2> &p : fill_polygon(polygon, h))
    cloud.append(p, ParticleKind::fluid, h);
}

Polygon box(const double x_0, const double y_0, const double x_1, const double y_1)
{
  return {{x_0, y_0}, {x_1, y_0}, {x_1, y_1}, {x_0, y_1}};
}

/// Wall particles from a to b.
void add_wall(ParticleCloud<2> &cloud, const Point<2> &a, const Point<2> &b)
{
  for (const Point<2> &p : sample_polyline({a, b}, h, false))
  {
    bool is_new = true;
    for (const Point<2> &q : cloud.position)
      is_new = is_new && p.distance(q) > 0.3 * h;
    if (is_new)
      cloud.append(p, ParticleKind::wall, h);
  }
}

bool contains(const FluidMesh<2> &mesh, const ParticleCloud<2> &cloud, const Point<2> &point)
{
  for (const Simplex<2> &cell : mesh.particle_cells())
  {
    const auto corners = corners_of<2>(cell, cloud.position);
    if (is_inside({corners[0], corners[1], corners[2]}, point))
      return true;
  }
  return false;
}

double created_volume(const ParticleCloud<2> &cloud, FluidMesh<2> &mesh, const Walls<2> &walls = Walls<2>())
{
  remesher<2>("plain").create_mesh(cloud, walls, {}, plain_region<2>(walls), mesh);
  return mesh.volume(cloud);
}

void test_shapes()
{
  FluidMesh<2> mesh;
  {
    // A ring: two rows of particles around a hole of radius 3 h.
    ParticleCloud<2> cloud;
    for (const double radius : {3. * h, 4. * h})
    {
      const unsigned int n = std::round(2. * numbers::PI * radius / h);
      for (unsigned int i = 0; i < n; ++i)
        cloud.append({radius * std::cos(2. * numbers::PI * i / n),
                      radius * std::sin(2. * numbers::PI * i / n)},
                     ParticleKind::fluid, h);
    }
    const double volume = created_volume(cloud, mesh);
    check("hole stays open", !contains(mesh, cloud, {0., 0.}) && mesh.n_vertices() == cloud.size());
    check("area of the ring", volume / (numbers::PI * 7. * h * h) - 1., 0.05);
  }
  {
    // Two bodies joined by a neck of width 2 h; two bodies 2 h apart.
    ParticleCloud<2> joined;
    fill(joined, {{0., 0.},
                  {1., 0.},
                  {1., 0.4},
                  {1.4, 0.4},
                  {1.4, 0.},
                  {2.4, 0.},
                  {2.4, 1.},
                  {1.4, 1.},
                  {1.4, 0.6},
                  {1., 0.6},
                  {1., 1.},
                  {0., 1.}});
    created_volume(joined, mesh);
    check("a neck stays", contains(mesh, joined, {1.22, 0.51}) && contains(mesh, joined, {1.15, 0.45}));
    check("the notches beside it stay open",
          !contains(mesh, joined, {1.2, 0.2}) && !contains(mesh, joined, {1.2, 0.8}));

    ParticleCloud<2> apart;
    fill(apart, box(0., 0., 1., 1.));
    fill(apart, box(1.25, 0., 2., 1.));
    const double volume = created_volume(apart, mesh);
    check("a gap of 2.5 h is not bridged", volume - 1.75, 1e-10);
  }
  {
    // A drop over a wall: contact elements where it is near, none of wall particles alone.
    ParticleCloud<2> cloud;
    add_wall(cloud, {-1., 0.}, {1., 0.});
    const unsigned int n_wall = cloud.size();
    Polygon drop;
    for (unsigned int i = 0; i < 19; ++i)
      drop.emplace_back(0.3 * std::cos(2. * numbers::PI * i / 19),
                        0.38 + 0.3 * std::sin(2. * numbers::PI * i / 19));
    fill(cloud, drop);
    created_volume(cloud, mesh);
    unsigned int n_contact = 0, n_wall_only = 0;
    for (const Simplex<2> &cell : mesh.particle_cells())
    {
      unsigned int n = 0;
      for (const unsigned int particle : cell)
        n += particle < n_wall;
      n_contact += (n == 1 || n == 2);
      n_wall_only += (n == 3);
    }
    check("a drop touches the wall", n_contact >= 2 && n_contact <= 12);
    check("no cell of wall particles alone", n_wall_only == 0);
    check("the wall far away stays dry", !contains(mesh, cloud, {0.9, 1e-3}) && !mesh.particles().empty());
  }
}

void test_degenerate()
{
  FluidMesh<2> mesh;
  ParticleCloud<2> cloud;
  check("empty cloud", created_volume(cloud, mesh) == 0. && mesh.n_cells() == 0);
  cloud.append({0., 0.}, ParticleKind::fluid, h);
  cloud.append({h, 0.}, ParticleKind::fluid, h);
  check("two particles", created_volume(cloud, mesh) == 0. && mesh.n_cells() == 0);
  for (unsigned int i = 2; i < 10; ++i)
    cloud.append({i * h, 0.}, ParticleKind::fluid, h);
  check("collinear particles", created_volume(cloud, mesh) == 0. && mesh.n_cells() == 0);
  cloud.append({4.5 * h, 1e-9 * h}, ParticleKind::fluid, h);
  check("a sliver is no fluid", created_volume(cloud, mesh) == 0. && mesh.n_cells() == 0);

  ParticleCloud<2> twice;
  fill(twice, box(0., 0., 1., 1.));
  const unsigned int n = twice.size();
  for (unsigned int i = 0; i < n; ++i)
    twice.append(twice.position[i], ParticleKind::fluid, h);
  check("every particle twice: the volume counts once", created_volume(twice, mesh) - 1., 1e-10);
  check("one of the two has cells", mesh.n_vertices() == n);
  check("remeshing bears it",
        (remesher<2>("advected").remesh(twice, Walls<2>(), {}, 1e-3, mesh), mesh.volume(twice)) - 1., 1e-10);

  for (const std::string rule : {"plain", "advected"})
  {
    ParticleCloud<2> nothing;
    FluidMesh<2> no_mesh;
    remesher<2>(rule).remesh(nothing, Walls<2>(), {}, 1e-3, no_mesh);
    check("remeshing of no particles, " + rule, no_mesh.n_cells() == 0);
  }
}

/// A lattice of cospherical points must be filled by positive simplices.
template <int dim>
void test_lattice(const unsigned int n)
{
  std::vector<Point<dim>> points;
  for (unsigned int i = 0; i < std::pow(n + 1, dim); ++i)
  {
    Point<dim> p;
    for (unsigned int d = 0, k = i; d < dim; ++d, k /= n + 1)
      p[d] = double(k % (n + 1)) / n;
    points.push_back(p);
  }
  points.push_back(points.front());
  double volume = 0., smallest = 1.;
  for (const Simplex<dim> &simplex : delaunay(points))
  {
    const double cell_volume = signed_volume<dim>(corners_of<dim>(simplex, points));
    volume += cell_volume;
    smallest = std::min(smallest, cell_volume * std::pow(n, dim));
  }
  const std::string name = Utilities::int_to_string(dim) + "D lattice: ";
  check(name + "the simplices fill the cube", volume - 1., 1e-12);
  check(name + "no simplex is inverted", smallest > -1e-12);
  check(name + "fewer than dim+1 points have no simplex",
        delaunay(std::vector<Point<dim>>(points.begin(), points.begin() + dim)).empty());
  check(name + "points on one line have no simplex",
        delaunay(std::vector<Point<dim>>(points.begin(), points.begin() + n)).empty());
}

void test_rules()
{
  // A level column between walls that stand above its surface.
  ParticleCloud<2> column;
  for (const auto &[a, b] : std::vector<std::pair<Point<2>, Point<2>>>{{{0., 0.}, {0., 0.5}},
                                                                       {{0., 0.5}, {0., 2.}},
                                                                       {{1., 0.}, {1., 0.5}},
                                                                       {{1., 0.5}, {1., 2.}},
                                                                       {{0., 0.}, {1., 0.}}})
    add_wall(column, a, b);
  for (const Point<2> &p : fill_polygon(box(0., 0., 1., 0.5), h))
    if (p[0] > 0.01 && p[0] < 0.99 && p[1] > 0.01)
      column.append(p, ParticleKind::fluid, h);
  FluidMesh<2> mesh;
  // Its surface is at y = 0.5. In the lower corners three wall particles may take a cell's area away, no more.
  const auto is_level = [&]() {
    bool level = mesh.volume(column) < 0.5 + 1e-10 && mesh.volume(column) > 0.5 - 1.01 * h * h;
    for (const Simplex<2> &cell : mesh.particle_cells())
      level = level && centroid<2>(corners_of<2>(cell, column.position))[1] < 0.5;
    return level;
  };
  created_volume(column, mesh);
  std::vector<Simplex<2>> below;
  for (const Simplex<2> &cell : mesh.particle_cells())
    if (centroid<2>(corners_of<2>(cell, column.position))[1] < 0.5)
      below.push_back(cell);
  mesh.reinit(column, below);
  for (unsigned int repetition = 0; repetition < 10; ++repetition)
    remesher<2>("advected").remesh(column, Walls<2>(), {}, 1e-3, mesh);
  check("remeshing: a level fluid does not climb dry walls", is_level());

  // Inside the old domain the advected rule keeps what the plain one drops: a cloud stretched to twice its length.
  ParticleCloud<2> stretched;
  fill(stretched, box(0., 0., 1., 1.));
  created_volume(stretched, mesh);
  for (Point<2> &p : stretched.position)
    p[0] *= 1.45;
  ParticleCloud<2> copy(stretched);
  FluidMesh<2> copy_mesh;
  created_volume(copy, copy_mesh);
  remesher<2>("advected").remesh(stretched, Walls<2>(), {}, 1e-3, mesh);
  check("advected: a stretched fluid keeps its volume", mesh.volume(stretched) - 1.45, 1e-10);

  // Fluid particles that move towards each other merge late, those of one domain stay together.
  for (const double gap : {0.3 * h, 0.1 * h})
  {
    ParticleCloud<2> two;
    fill(two, box(0., 0., 0.5, 1.));
    fill(two, box(1., 0., 1.5, 1.));
    created_volume(two, mesh);
    for (Point<2> &p : two.position)
      if (p[0] > 0.9)
        p[0] -= 0.5 - gap;
    for (unsigned int i = 0; i < two.size(); ++i)
      two.velocity[i][0] = two.position[i][0] > 0.5 + 0.5 * gap ? -1. : 0.;
    ParticleCloud<2> plain(two);
    FluidMesh<2> plain_mesh;
    plain_mesh.reinit(plain, mesh.particle_cells());
    mesh.move(two);
    remesher<2>("plain").remesh(plain, Walls<2>(), {}, 1e-3, plain_mesh);
    check("plain: two bodies merge from afar", plain_mesh.volume(plain) - (1. + gap), 0.02);
    remesher<2>("advected").remesh(two, Walls<2>(), {}, 1e-3, mesh);
    check(gap > 0.2 * h ? "advected: bodies 0.3 h apart stay two" : "advected: bodies 0.1 h apart merge",
          mesh.volume(two) - (gap > 0.2 * h ? 1. : 1. + gap), 1e-3);
  }
  {
    ParticleCloud<2> two;
    fill(two, box(0., 0., 0.5, 1.));
    fill(two, box(1., 0., 1.5, 1.));
    created_volume(two, mesh);
    for (Point<2> &p : two.position)
      if (p[0] > 0.9)
        p[0] -= 0.5 - 1.35 * h;
    remesher<2>("advected").remesh(two, Walls<2>(), {}, 1e-3, mesh);
    check("advected: bodies 1.35 h apart stay two", mesh.volume(two) - 1., 1e-10);
  }
  {
    // Fluid over a dry floor, at 0.8 h: it becomes contact only if it comes down fast, or is near.
    for (const double speed : {0., 1., -1e-3, -60.})
    {
      ParticleCloud<2> falling;
      add_wall(falling, {-0.5, 0.}, {1.5, 0.});
      fill(falling, box(0., 3. * h, 1., 0.8));
      created_volume(falling, mesh);
      const double before = mesh.volume(falling);
      for (unsigned int i = 0; i < falling.size(); ++i)
        if (falling.kind[i] == ParticleKind::fluid)
        {
          falling.position[i][1] -= 2.2 * h;
          falling.velocity[i][1] = speed;
        }
      remesher<2>("advected").remesh(falling, Walls<2>(), {}, 1e-3, mesh);
      check("fluid at 0.8 h over a dry wall with speed " + std::to_string(int(speed)) +
              (speed < -1. ? " touches it" : " does not touch it"),
            (mesh.volume(falling) > before + 1e-10) == (speed < -1.));
    }
  }
}

void test_thin_wall()
{
  // Two layers of fluid, half a spacing apart, on the two sides of a wall without thickness.
  const Walls<2> walls({{{{{-1., 0.}, {2., 0.}}}, true}});
  ParticleCloud<2> cloud;
  fill(cloud, box(0., 0.25 * h, 1., 0.5));
  fill(cloud, box(0., -0.5, 1., -0.25 * h));
  FluidMesh<2> mesh;
  const double expected = 2. * (0.5 - 0.25 * h);
  check("without the wall the layers join", created_volume(cloud, mesh) - 1., 1e-2);
  check("plain: no cell crosses a thin wall", created_volume(cloud, mesh, walls) - expected, 1e-10);
  remesher<2>("advected").remesh(cloud, walls, {}, 1e-3, mesh);
  check("advected: no cell crosses a thin wall", mesh.volume(cloud) - expected, 1e-10);
}

/// Fluid that has landed on both sides of a ridge, or a valley, of facets at 23 degrees, and some above.
void test_bend()
{
  for (const double slope : {-0.2, 0.2})
  {
    const auto at = [&](const double x, const double y) { return Point<3>(x, y, slope * std::abs(x)); };
    const std::array<std::array<Point<3>, 3>, 4> facets = {{{{at(-1., -1.), at(0., -1.), at(0., 1.)}},
                                                            {{at(-1., -1.), at(0., 1.), at(-1., 1.)}},
                                                            {{at(0., -1.), at(1., -1.), at(1., 1.)}},
                                                            {{at(0., -1.), at(1., 1.), at(0., 1.)}}}};
    std::vector<WallFacet<3>> wall;
    for (const auto &corners : facets)
      wall.push_back({corners, true, 0, false, true});
    const Walls<3> walls(wall);
    ParticleCloud<3> cloud;
    for (const Point<2> &p : {Point<2>(-0.6 * h, -0.5 * h), Point<2>(-0.6 * h, 0.5 * h),
                              Point<2>(0.6 * h, 0.1 * h), Point<2>(0.1 * h, -0.5 * h)})
    {
      const unsigned int i       = cloud.append(at(p[0], p[1]) + Point<3>(0., 0., contact_offset * h),
                                                ParticleKind::fluid, h);
      cloud.contact_facets[i][0] = p[0] < 0. ? 0 : 2;
    }
    const unsigned int above = cloud.append({0.1 * h, 0.05 * h, h}, ParticleKind::fluid, h);
    AlphaShape<3> rule;
    parse(rule);
    Simplex<3> flat = {{0, 1, 2, 3}};
    if (!(signed_volume<3>(corners_of<3>(flat, cloud.position)) > 0.))
      std::swap(flat[0], flat[1]);
    const std::string name = slope < 0. ? "ridge" : "valley";
    check(name + ": the cell between landed particles is fluid in a valley, none below a ridge",
          rule.accepts_plain(flat, cloud, walls) == (slope > 0.));
    Simplex<3> upper = {{0, 1, 2, above}};
    if (!(signed_volume<3>(corners_of<3>(upper, cloud.position)) > 0.))
      std::swap(upper[0], upper[1]);
    check(name + ": a cell over chords is fluid", rule.accepts_plain(upper, cloud, walls));
  }
}

void test_3d()
{
  Random random;
  ParticleCloud<3> cloud;
  const unsigned int n = 6;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int k = 0; k <= n; ++k)
      {
        const bool inside        = std::min({i, j, k}) > 0 && std::max({i, j, k}) < n;
        const Tensor<1, 3> shift = 0.1 * random.vector<3>();
        cloud.append(h * (Point<3>(i, j, k) + (inside ? shift : Tensor<1, 3>())),
                     k == 0 ? ParticleKind::wall : ParticleKind::fluid, h);
      }
  const unsigned int isolated = cloud.append({3., 3., 3.}, ParticleKind::fluid, h);
  FluidMesh<3> mesh;
  const Walls<3> no_walls;
  remesher<3>("advected").create_mesh(cloud, no_walls, {}, plain_region<3>(no_walls), mesh);
  check("3D: the mesh fills the cube", mesh.volume(cloud) / std::pow(n * h, 3) - 1., 1e-2);
  check("3D: a particle far away is isolated", mesh.particles().back() < isolated);
  for (Point<3> &p : cloud.position)
    p[2] *= 1.05;
  remesher<3>("advected").remesh(cloud, Walls<3>(), {}, 1e-3, mesh);
  check("3D: remeshing keeps the volume", mesh.volume(cloud) / (1.05 * std::pow(n * h, 3)) - 1., 1e-2);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_shapes();
  test_degenerate();
  test_lattice<2>(6);
  test_lattice<3>(5);
  test_rules();
  test_thin_wall();
  test_bend();
  test_3d();
  return n_failed;
}
