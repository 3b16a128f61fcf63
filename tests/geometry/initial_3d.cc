// SPDX-License-Identifier: GPL-3.0-or-later

// Test the initial particles and walls in space: volumes, spacing and shape of the cells of boxes, wedges, cones and
// cylinders on a floor; plane polygons; and the errors of wrong geometries.

#include <lahar/geometry/plane_polygon.h>
#include <lahar/geometry/point_set.h>
#include <lahar/remeshing/simplex_geometry.h>

#include "initial_case.h"

using namespace Tests;

using Case = InitialCase<3>;

const std::string floor_wall = "-2, -2, 0 : 2, -2, 0 : 2, 2, 0 : -2, 2, 0";

/// Check the mesh of a body on the floor z = 0 against its volume.
void test_body(const std::string &name, const Entries &body, const double volume, const double tolerance,
               const double h)
{
  Entries entries = body;
  entries.emplace_back("No-slip walls", floor_wall);
  const Case c(entries, h);
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

void check_error(const std::string &what, const Entries &entries, const std::vector<std::string> &parts,
                 const double h = 0.2)
{
  check_throws<InputError>(what, parts, [&]() { Case(entries, h); });
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

  test_body("box", {{"Fluid boxes", "-0.5, 0, 0 : 0.5, 0.8, 0.6"}}, 0.48, 1e-10, 0.1);
  test_body("wedge",
            {{"Fluid polyhedra",
              "0, 0, 0 : 1.2, 0, 0 : 1.2, 0, 0.6 : 0, 1, 0 : 1.2, 1, 0 : 1.2, 1, 0.6 : 0, 0, 0"}},
            0.36, 0.02, 0.1);
  const auto cone = [](const double R, const double r, const double H) {
    return numbers::PI / 3. * H * (R * R + R * r + r * r);
  };
  // The chords of the rings cut off (h/R)²/6 of the volume.
  test_body("cone", {{"Fluid cones", "0, 0, 0 : 1, 0.5, 1.5"}}, cone(1., 0.5, 1.5), 0.005, 0.12);
  test_body("cylinder", {{"Fluid cones", "0.5, 0, 0 : 0.5, 0.5, 1"}}, cone(0.5, 0.5, 1.), 0.012, 0.1);

  const Point<3> end(0.9, 1.2, 0.8); // 1.7 m from the origin
  const Case tilted({{"Fluid cylinders", "0, 0, 0 : 0.9, 1.2, 0.8 : 0.4"}}, 0.1);
  check("cylinder in any direction: volume",
        tilted.mesh.volume(tilted.cloud) / (numbers::PI * 0.16 * 1.7) - 1., 0.015);
  double outside = 0.;
  for (const Point<3> &p : tilted.cloud.position)
  {
    const double along = p * (end / 1.7);
    outside            = std::max({outside, -along, along - 1.7, (p - along * (end / 1.7)).norm() - 0.4});
  }
  check("cylinder in any direction: particles lie in it", outside, 1e-12);

  const Case two({{"Fluid boxes", "0, 0, 0 : 1, 1, 1; 1, 0, 0 : 2, 1, 1"}}, 0.2);
  check("two boxes side by side", two.mesh.volume(two.cloud) - 2., 1e-10);
  for (const double h : {0.25, 0.2, 0.13})
    for (const std::string start : {"1.25", "1.3", "1.4"})
    {
      const Case apart({{"Fluid boxes", "0, 0, 0 : 1, 1, 1; " + start + ", 0.3, 0 : 2, 1.3, 0.7"}}, h);
      check("boxes apart, the second from x = " + start,
            apart.mesh.volume(apart.cloud) - (1. + 0.7 * (2. - std::stod(start))), 1e-10);
    }
  const Case corners({{"Fluid boxes", "0, 0, 0 : 1, 1, 1; 1, 1, 0 : 2, 2, 1; 0, 0, 1 : -1, -1, 2"}}, 0.2);
  check("boxes that touch in an edge and a corner", corners.mesh.volume(corners.cloud) - 3., 1e-10);
  const Case slip({{"Fluid boxes", "0, 0, 0 : 1, 1, 1"}, {"Slip walls", floor_wall}}, 0.2);
  check("slip walls carry no particles",
        slip.cloud.n_particles(ParticleKind::wall) == 0 && slip.walls.facets().size() == 2);

  check_error("no fluid", {{"No-slip walls", floor_wall}}, {"Geometry/Fluid boxes", "Geometry/Fluid cones"});
  check_error("a flat box", {{"Fluid boxes", "0, 0, 0 : 1, 1, 0"}},
              {"Geometry/Fluid boxes", "different x, y and z"});
  check_error("a plane point", {{"Fluid boxes", "0, 0 : 1, 1"}}, {"Geometry/Fluid boxes", "x, y, z"});
  check_error("a polyhedron in a plane", {{"Fluid polyhedra", "0, 0, 0 : 1, 0, 0 : 0, 1, 0 : 1, 1, 0"}},
              {"Geometry/Fluid polyhedra", "do not lie in one plane"});
  check_error("a cone with a top wider than its base", {{"Fluid cones", "0, 0, 0 : 0.5, 1, 1"}},
              {"Geometry/Fluid cones", "wider"});
  check_error("a cone without height", {{"Fluid cones", "0, 0, 0 : 0.5, 0.5, 0"}},
              {"Geometry/Fluid cones", "above 0"});
  for (const std::string cylinder : {"0, 0, 0 : 0, 0, 0 : 0.5", "0, 0, 0 : 0, 1, 0 : 0", "0, 0, 0 : 0, 1, 0",
                                     "0, 0, 0 : 0, 1, 0 : wide", "0.5"})
    check_error("cylinder '" + cylinder + "'", {{"Fluid cylinders", cylinder}},
                {"Geometry/Fluid cylinders", cylinder, "radius"});
  check_error("a wall through the fluid",
              {{"Fluid boxes", "-1, -1, -1 : 1, 1, 1"}, {"No-slip walls", floor_wall}},
              {"overlaps wall", "Geometry/No-slip walls"});
  check_error("a bent wall",
              {{"Fluid boxes", "0, 0, 0 : 1, 1, 1"},
               {"Slip walls", "0, 0, 0 : 1, 0, 0 : 1, 1, 0.3 : 0, 1, 0"}},
              {"Geometry/Slip walls", "one plane"});
  check_error("overlapping bodies",
              {{"Fluid boxes", "0, 0, 0 : 1, 1, 1"}, {"Fluid cones", "0, 0, 0 : 0.5, 0.5, 0.5"}},
              {"overlaps fluid body", "Fluid cones"});
  check_error("body below the mesh size", {{"Fluid boxes", "0, 0, 0 : 1, 1, 0.1"}}, {"Mesh size", "0.1"});
  test_ranks<3>("cone and box",
                {{"Fluid cones", "0, 0, 0 : 0.5, 0.3, 0.6"},
                 {"Fluid boxes", "1, -0.5, 0 : 1.5, 0.5, 0.5"},
                 {"No-slip walls", floor_wall}},
                0.06);
  return n_failed > 0;
}
