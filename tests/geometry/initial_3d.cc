// SPDX-License-Identifier: GPL-3.0-or-later

// Test the initial particles and walls in space: volumes, spacing and shape of the cells of boxes, wedges, cones and
// cylinders on a floor; plane polygons; and the errors of wrong geometries.

#include <lahar/geometry/plane_polygon.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/simplex_geometry.h>

#include "initial_case.h"

using namespace Tests;

using Case = InitialCase<3>;

const std::string floor_wall = "-2, -2, 0 : 2, -2, 0 : 2, 2, 0 : -2, 2, 0";

/// Check the mesh of a body on the floor z = 0 against its volume.
void test_body(const std::string &name, const Part &body, const double volume, const double tolerance,
               const double h)
{
  const Case c({body, planes(floor_wall)}, h);
  check(name + ": volume", c.mesh.volume(c.cloud) / volume - 1., tolerance);

  PointSet<3> places;
  double nearest = 1e10;
  bool on_floor = true, above_floor = true;
  for (unsigned int i = 0; i < c.cloud.size(); ++i)
  {
    const Point<3> &p = c.cloud.position[i];
    for (const unsigned int j : places.near(p, 2. * h))
      nearest = std::min(nearest, p.distance(c.cloud.position[j]));
    places.insert(p);
    if (c.cloud.kind[i] == ParticleKind::wall)
      on_floor = on_floor && std::abs(p[2]) < 1e-12;
    else
      above_floor = above_floor && p[2] > 0.3 * h;
  }
  check(name + ": particles keep their distance", nearest > 0.45 * h);
  check(name + ": wall particles lie on the floor, fluid above it", on_floor && above_floor);

  // Six tetrahedra a particle, as in the lattice.
  const double n_expected = 6. * std::sqrt(2.) * volume / (h * h * h);
  check(name + ": number of cells", c.mesh.n_cells() / n_expected - 1., 0.35);
}

void check_error(const std::string &what, const Parts &case_parts, const std::vector<std::string> &parts,
                 const double h = 0.2)
{
  check_throws<InputError>(what, parts, [&]() { Case(case_parts, h); });
}

Part cone(const std::string &base, const std::string &base_radius, const std::string &top_radius,
          const std::string &height)
{
  return fluid_of(
    "cone", {{"Base", base}, {"Base radius", base_radius}, {"Top radius", top_radius}, {"Height", height}},
    "cone");
}

Part cylinder(const std::string &ends, const std::string &radius)
{
  return fluid_of("cylinder", {{"Ends", ends}, {"Radius", radius}}, "bar");
}

Part convex(const std::string &corners)
{
  return fluid_of("convex", {{"Corners", corners}});
}

void test_polygon()
{
  // An L would not be convex; a trapezium that leans is.
  const PlanePolygon trapezium({{0., 0., 0.}, {2., 0., 2.}, {1.5, 1., 1.5}, {0.5, 1., 0.5}});
  double area = 0.;
  for (const auto &[a, b, c] : trapezium.triangles())
    area += 0.5 * cross_product_3d(b - a, c - a) * trapezium.normal();
  check("area of a plane polygon", area - 1.5 * std::sqrt(2.), 1e-12);
  double distance = 0.;
  for (const Point<3> &p : trapezium.fill(0.1))
    distance = std::max(distance, std::abs(trapezium.signed_distance(p)));
  check("its points lie in its plane", distance, 1e-12);
  check_throws<InputError>("corners not in one plane", {"one plane"}, [] {
    PlanePolygon({{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.1}, {0., 1., 0.}});
  });
  check_throws<InputError>("no convex polygon", {"convex"}, [] {
    PlanePolygon({{0., 0., 0.}, {2., 0., 0.}, {2., 2., 0.}, {1.5, 0.5, 0.}});
  });
  check_throws<InputError>("corners on a line", {"line"}, [] {
    PlanePolygon({{0., 0., 0.}, {2., 0., 0.}, {1., 0., 0.}});
  });
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_polygon();

  test_body("box", boxes("-0.5, 0, 0 : 0.5, 0.8, 0.6"), 0.48, 1e-10, 0.1);
  test_body("wedge",
            convex("0, 0, 0 : 1.2, 0, 0 : 1.2, 0, 0.6 : 0, 1, 0 : 1.2, 1, 0 : 1.2, 1, 0.6 : 0, 0, 0"), 0.36,
            0.02, 0.1);
  const auto volume_of = [](const double R, const double r, const double H) {
    return numbers::PI / 3. * H * (R * R + R * r + r * r);
  };
  // The chords of the rings cut off (h/R)²/6 of the volume.
  test_body("cone", cone("0, 0, 0", "1", "0.5", "1.5"), volume_of(1., 0.5, 1.5), 0.005, 0.12);
  test_body("cylinder", cone("0.5, 0, 0", "0.5", "0.5", "1"), volume_of(0.5, 0.5, 1.), 0.012, 0.1);

  const Point<3> end(0.9, 1.2, 0.8); // 1.7 m from the origin
  const Case tilted({cylinder("0, 0, 0 : 0.9, 1.2, 0.8", "0.4")}, 0.1);
  check("cylinder in any direction: volume",
        tilted.mesh.volume(tilted.cloud) / (numbers::PI * 0.16 * 1.7) - 1., 0.015);
  double outside = 0.;
  for (const Point<3> &p : tilted.cloud.position)
  {
    const double along = p * (end / 1.7);
    outside            = std::max({outside, -along, along - 1.7, (p - along * (end / 1.7)).norm() - 0.4});
  }
  check("cylinder in any direction: particles lie in it", outside, 1e-12);

  const Case two({boxes("0, 0, 0 : 1, 1, 1; 1, 0, 0 : 2, 1, 1")}, 0.2);
  check("two boxes side by side", two.mesh.volume(two.cloud) - 2., 1e-10);
  for (const double h : {0.25, 0.2, 0.13})
    for (const std::string start : {"1.25", "1.3", "1.4"})
    {
      const Case apart({boxes("0, 0, 0 : 1, 1, 1; " + start + ", 0.3, 0 : 2, 1.3, 0.7")}, h);
      check("boxes apart, the second from x = " + start,
            apart.mesh.volume(apart.cloud) - (1. + 0.7 * (2. - std::stod(start))), 1e-10);
    }
  const Case corners({boxes("0, 0, 0 : 1, 1, 1; 1, 1, 0 : 2, 2, 1; 0, 0, 1 : -1, -1, 2")}, 0.2);
  check("boxes that touch in an edge and a corner", corners.mesh.volume(corners.cloud) - 3., 1e-10);
  const Case slip({boxes("0, 0, 0 : 1, 1, 1"), planes(floor_wall, "free slip")}, 0.2);
  check("slip walls carry no particles",
        slip.cloud.n_particles(ParticleKind::wall) == 0 && slip.walls.facets().size() == 2);

  check_error("no fluid", {planes(floor_wall)}, {"no fluid", "'Fluids' and 'Solids' are empty"});
  check_error("a flat box", {boxes("0, 0, 0 : 1, 1, 0")},
              {"'Fluids/fluid/box/Corners'", "different x, y and z"});
  check_error("a plane point", {boxes("0, 0 : 1, 1")}, {"'Fluids/fluid/box/Corners'", "x, y, z"});
  check_error("a polyhedron in a plane", {convex("0, 0, 0 : 1, 0, 0 : 0, 1, 0 : 1, 1, 0")},
              {"'Fluids/fluid/convex/Corners'", "do not lie in one plane"});
  check_error("a cone with a top wider than its base", {cone("0, 0, 0", "0.5", "1", "1")},
              {"'Fluids/cone/cone/Top radius'", "up to 'Base radius', which is 0.5"});
  check_error("a cone without height", {cone("0, 0, 0", "0.5", "0.5", "0")},
              {"'Fluids/cone/cone/Height'", "'0'", "Allowed"});
  for (const std::string ends : {"0, 0, 0 : 0, 0, 0", "0, 0, 0", "0, 0, 0 : 0, 1, 0 : 0, 2, 0", "0.5", ""})
    check_error("ends of a cylinder '" + ends + "'", {cylinder(ends, "0.5")},
                {"'Fluids/bar/cylinder/Ends'", "'" + ends + "'", "Allowed"});
  for (const std::string radius : {"0", "wide", ""})
    check_error("radius of a cylinder '" + radius + "'", {cylinder("0, 0, 0 : 0, 1, 0", radius)},
                {"'Fluids/bar/cylinder/Radius'", "'" + radius + "'", "Allowed"});
  check_error("a wall through the fluid", {boxes("-1, -1, -1 : 1, 1, 1"), planes(floor_wall)},
              {"Fluid 'fluid' overlaps boundary 'walls'"});
  check_error("a bent wall",
              {boxes("0, 0, 0 : 1, 1, 1"), planes("0, 0, 0 : 1, 0, 0 : 1, 1, 0.3 : 0, 1, 0", "free slip")},
              {"'Boundaries/walls/polygon/Corners'", "one plane"});
  check_error("overlapping bodies", {boxes("0, 0, 0 : 1, 1, 1"), cone("0, 0, 0", "0.5", "0.5", "0.5")},
              {"overlaps fluid", "'fluid'", "'cone'"});
  check_error("body below the mesh size", {boxes("0, 0, 0 : 1, 1, 0.1")}, {"Mesh size", "0.1"});
  test_ranks<3>("cone and box",
                {cone("0, 0, 0", "0.5", "0.3", "0.6"), boxes("1, -0.5, 0 : 1.5, 0.5, 0.5"),
                 planes(floor_wall)},
                0.06);
  return n_failed > 0;
}
