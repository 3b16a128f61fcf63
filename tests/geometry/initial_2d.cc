// SPDX-License-Identifier: GPL-3.0-or-later

// Test the initial particles and walls of boxes, polygons and gmsh groups: areas, spacing, contact points on walls, no
// particle inside a wall; the polygon functions; and the errors of wrong geometries.

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/polygon.h>
#include <lahar/geometry/simplex_geometry.h>

#include "initial_case.h"

#include <fstream>

using namespace Tests;

struct Case : InitialCase<2>
{
  using InitialCase::InitialCase;

  double nearest_distance() const
  {
    double nearest = 1e10;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        nearest = std::min(nearest, cloud.position[i].distance(cloud.position[j]));
    return nearest;
  }

  bool has_particle(const Point<2> &p, const ParticleKind kind) const
  {
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (cloud.position[i].distance(p) < 1e-12 && cloud.kind[i] == kind)
        return true;
    return false;
  }
};

void check_error(const std::string &what, const Parts &case_parts, const std::vector<std::string> &parts,
                 const double h = 0.1)
{
  check_throws<InputError>(what, parts, [&]() { Case(case_parts, h); });
}

void test_polygons()
{
  const Polygon L = {{0., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 3.}, {0., 3.}};
  check("area", signed_area(L) - 4., 1e-14);
  check("area of clockwise corners", signed_area(Polygon(L.rbegin(), L.rend())) + 4., 1e-14);
  check("inside", is_inside(L, {0.5, 2.5}) && is_inside(L, {1.9, 0.1}));
  check("outside", !is_inside(L, {1.5, 1.5}) && !is_inside(L, {-0.1, 0.5}));
  check("distance from a segment", distance_to_segment({3., 4.}, {0., 0.}, {0., 0.1}) - std::hypot(3., 3.9),
        1e-14);
  check("distance from the contour", distance_to_contour(L, {0.5, 2.}) - 0.5, 1e-14);
  check("a bow tie intersects itself", is_self_intersecting({{0., 0.}, {1., 1.}, {1., 0.}, {0., 1.}}));
  check("an L does not", !is_self_intersecting(L));

  for (const double h : {0.3, 0.1, 0.07})
  {
    const std::vector<Point<2>> line = sample_polyline({{0., 0.}, {1., 0.}, {1., 0.5}}, h, false);
    double longest                   = 0.;
    for (unsigned int i = 1; i < line.size(); ++i)
      longest = std::max(longest, line[i].distance(line[i - 1]) / h);
    check("pieces of a line are at most 1.5 h long", longest <= 1.5);
    check("a line keeps its corners",
          std::count(line.begin(), line.end(), Point<2>(1., 0.)) == 1 && line.back() == Point<2>(1., 0.5));

    const std::vector<Point<2>> points = fill_polygon(L, h);
    bool inside                        = true;
    double nearest                     = 1e10;
    for (unsigned int i = 0; i < points.size(); ++i)
    {
      inside = inside && (is_inside(L, points[i]) || distance_to_contour(L, points[i]) < 1e-12);
      for (unsigned int j = 0; j < i; ++j)
        nearest = std::min(nearest, points[i].distance(points[j]) / h);
    }
    check("a filled polygon's points lie in it", inside);
    check("they are at least h/2 apart", nearest > 0.5);
    check("their number is that of equilateral triangles", points.size() * std::sqrt(0.75) * h * h / 4. - 1.,
          0.25);
  }
}

void test_column(const Case &column, const double h)
{
  const double area = 0.146 * 0.292;
  // In the hollow corner three wall particles may take a cell's area away, no more.
  const double error = column.mesh.volume(column.cloud) - area;
  check("the mesh fills the column", error < 1e-10 && error > -0.75 * h * h);
  bool beside = false;
  for (const Simplex<2> &cell : column.mesh.particle_cells())
  {
    const Point<2> p = centroid<2>(corners_of<2>(cell, column.cloud.position));
    beside           = beside || p[0] > 0.146 || p[1] > 0.292;
  }
  check("no cell outside the column", !beside);
  check("particles keep their distance", column.nearest_distance() > 0.3 * h);
  check("wall particles stand on the floor and the wall",
        column.has_particle({0., 0.}, ParticleKind::wall) &&
          column.has_particle({0.5, 0.}, ParticleKind::wall) &&
          column.has_particle({0., 0.4}, ParticleKind::wall));
  check("the surface meets the wall in a wall particle",
        column.has_particle({0., 0.292}, ParticleKind::wall));
  check("the front meets the floor in a wall particle", column.has_particle({0.146, 0.}, ParticleKind::wall));
  bool on_walls = true, fluid_off_walls = true;
  for (unsigned int i = 0; i < column.cloud.size(); ++i)
  {
    const Point<2> &p  = column.cloud.position[i];
    const double depth = std::min(p[0], p[1]);
    if (column.cloud.kind[i] == ParticleKind::wall)
      on_walls = on_walls && std::abs(depth) < 1e-12;
    else
      fluid_off_walls = fluid_off_walls && depth > 0.2 * h;
  }
  check("wall particles lie on the walls, fluid off them", on_walls && fluid_off_walls);
}

/// The first mesh of polygons and boxes is the region that they fill, whatever the mesh size, but for hollow corners.
void test_shapes()
{
  const auto volume = [](const Part &fluid, const double h) {
    const Case c({fluid}, h);
    return c.mesh.volume(c.cloud);
  };
  for (const double h : {0.02, 0.013, 0.01, 0.0071, 0.004})
  {
    const std::string size = ", h = " + std::to_string(h);
    // Beside what is narrower than half a mesh size cells are missing, but none is across.
    const auto check_volume = [&](const std::string &name, const double found, const double asked,
                                  const bool is_narrow) {
      check(name + size,
            is_narrow ? found < asked + 1e-12 && found > 0.9 * asked : std::abs(found - asked) < 1e-12);
    };
    for (const std::string width : {"0.001", "0.01", "0.02", "0.035"})
    {
      const double w       = std::stod(width);
      const auto x         = [](const double place) { return std::to_string(place); };
      const bool is_narrow = w < 0.5 * h;
      check_volume("slot " + width,
                   volume(polygons("0, 0 : 0.3, 0 : 0.3, 0.2 : " + x(0.15 + 0.5 * w) +
                                   ", 0.2 : " + x(0.15 + 0.5 * w) + ", 0.05 : " + x(0.15 - 0.5 * w) +
                                   ", 0.05 : " + x(0.15 - 0.5 * w) + ", 0.2 : 0, 0.2"),
                          h),
                   0.06 - 0.15 * w, is_narrow);
      check_volume("boxes apart by " + width,
                   volume(boxes("0, 0 : 0.1, 0.1; " + x(0.1 + w) + ", 0.03 : " + x(0.2 + w) + ", 0.17"), h),
                   0.024, is_narrow);
    }
    check_volume("a notch",
                 volume(polygons("0, 0 : 0.3, 0 : 0.3, 0.2 : 0.16, 0.2 : 0.15, 0.1 : 0.14, 0.2 : 0, 0.2"), h),
                 0.059, true);
    check("boxes that touch in a corner" + size,
          volume(boxes("0, 0 : 0.1, 0.1; 0.1, 0.1 : 0.2, 0.2"), h) - 0.02, 1e-12);
    check("boxes that touch along a part" + size,
          volume(boxes("0, 0 : 0.1, 0.1; 0.1, 0.043 : 0.2, 0.143"), h) - 0.02, 1e-12);
    check("a wedge" + size, volume(polygons("0, 0 : 0.3, 0 : 0.3, 0.04"), h) - 0.006, 1e-12);
    const Case gap({boxes("0, 0 : 0.1, 0.1"), lines("0.104, -0.1 : 0.104, 0.2")}, h);
    check("a wall 4 mm beside the fluid" + size, gap.mesh.volume(gap.cloud) - (h > 0.04 ? 0.0104 : 0.01),
          1e-12);
  }
}

/// Particles, facets and velocities of two fluids between three boundaries.
void test_parts()
{
  Part left     = fluid_of("box", {{"Corners", "0, 0 : 1, 1"}}, "left"),
       right    = fluid_of("polygon", {{"Corners", "2, 0 : 3, 0 : 3, 1 : 2, 1"}}, "right");
  right.further = {{"Initial velocity", "x; -2*y"}, {"Law", "Newtonian"}};
  const Case c({left, right, boundary_of("polyline", {{"Points", "0, 0 : 3, 0"}}, "wall particles", "floor"),
                boundary_of("polyline", {{"Points", "0, 0 : 0, 2; 3, 0 : 3, 2"}}, "free slip", "sides"),
                boundary_of("polyline", {{"Points", "0, 3 : 3, 3"}}, "wall particles", "lid")},
               0.1);
  bool parts = true, moves = true;
  for (unsigned int i = 0; i < c.cloud.size(); ++i)
  {
    const Point<2> &p = c.cloud.position[i];
    const bool fluid  = c.cloud.kind[i] == ParticleKind::fluid;
    parts             = parts && c.cloud.part[i] == (fluid ? (p[0] > 1.5 ? 2U : 1U) : (p[1] > 2. ? 2U : 0U));
    const Tensor<1, 2> expected = fluid && p[0] > 1.5 ? Tensor<1, 2>({p[0], -2. * p[1]}) : Tensor<1, 2>();
    moves                       = moves && (c.cloud.velocity[i] - expected).norm() < 1e-12;
  }
  check("particles know their part", parts && c.cloud.n_particles(ParticleKind::wall) > 60);
  check("each fluid has its initial velocity", moves);
  const auto &facets = c.walls.facets();
  check("facets know their boundary and its law",
        facets.size() == 4 && facets[0].boundary == 0 && !facets[0].lands && facets[1].boundary == 1 &&
          facets[1].lands && facets[2].boundary == 1 && facets[2].lands && facets[3].boundary == 2 &&
          !facets[3].lands);
  check("walls know the names of the boundaries",
        c.walls.boundary_names() == std::vector<std::string>({"floor", "sides", "lid"}));
  const InitialGeometry<2> geometry = make_geometry<2>(
    {left, boundary_of("polyline", {{"Points", "0, 0 : 1, 0 : 1, 2"}}, "wall particles", "floor"),
     boundary_of("polyline", {{"Points", "0, 0 : 0, 2; 3, 0 : 3, 2"}}, "free slip", "sides")});
  check("messages call walls by their boundary", geometry.wall_name(1) == "'floor'" &&
                                                   geometry.wall_name(2) == "number 1 of 'sides'" &&
                                                   geometry.wall_name(3) == "number 2 of 'sides'");
  right.further                = {{"Law", "Newtonian"}};
  const InitialGeometry<2> two = make_geometry<2>({left, right});
  check("each fluid has its law", two.materials().n_fluids() == 2 &&
                                    two.materials().law(0).yield_stress(0.).value > 0. &&
                                    two.materials().law(1).yield_stress(0.).value == 0.);
  right.further                = {};
  const InitialGeometry<2> one = make_geometry<2>({left, right});
  check("fluids of the same law are one",
        one.materials().n_fluids() == 1 && one.fluid_names() == std::vector<std::string>{"left and right"});
  right.of_shape = {{"Corners", "0.5, 0 : 3, 0 : 3, 1 : 2, 1"}};
  right.further  = {};
  check_error("overlapping fluids", {left, right}, {"Fluid 'left' overlaps fluid 'right'"});
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_polygons();
  test_shapes();
  test_parts();

  const std::string walls = "0, 0.4 : 0, 0 : 0.5, 0";
  test_column(Case({boxes("0, 0 : 0.146, 0.292"), lines(walls)}, 0.02), 0.02);
  test_column(Case({boxes("0.146, 0.292 : 0, 0"), lines(walls)}, 0.006), 0.006);
  for (const std::string format : {"22", "41"})
  {
    const std::string file = SOURCE_DIR "/column_" + format + ".msh";
    test_column(Case({fluid_of("mesh", mesh_of(file, "fluid")),
                      boundary_of("mesh", mesh_of(file, "floor, left wall"))},
                     0.03),
                0.03);
    const GmshFile<2> mesh(file);
    double length = 0.;
    for (const auto &edge : mesh.facets_of("walls"))
      length += edge[0].distance(edge[1]);
    check("gmsh " + format + ": length of the walls", length - 0.9, 1e-12);
    check("gmsh " + format + ": nodes of the fluid", mesh.nodes_of("fluid").size() > 50);
    check_throws<InputError>("gmsh " + format + ": unknown group",
                             {file, "'roof'", "'floor'", "'left wall'", "'walls'"},
                             [&]() { mesh.facets_of("roof"); });
    check_throws<InputError>("gmsh " + format + ": a curve is no surface", {"'floor'", "'fluid'"},
                             [&]() { mesh.nodes_of("floor"); });

    // A truncated file is refused wherever it ends.
    std::ifstream in(file);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    bool refused = true;
    for (unsigned int k = 1; k < 20; ++k)
    {
      std::ofstream("truncated.msh") << text.substr(0, (text.size() - 20) * k / 20);
      try
      {
        GmshFile<2> truncated("truncated.msh");
        refused = false;
      }
      catch (const InputError &error)
      {
        refused = refused && std::string(error.what()).find("truncated.msh:") == 0;
      }
    }
    check("gmsh " + format + ": truncated files are refused with file and line", refused);
  }

  const Case slip({polygons("0, 0 : 1, 0 : 1.3, 0.5 : 1, 1 : 0, 1"),
                   lines("0, 2 : 0, 0 : 1, 0", "free slip")},
                  0.1);
  check("slip walls carry no particles", slip.cloud.n_particles(ParticleKind::wall) == 0 &&
                                           slip.walls.facets().size() == 2 && slip.walls.facets()[0].lands);
  check("a polygon is filled", slip.mesh.volume(slip.cloud) - 1.15, 3. * contact_offset * 0.1);
  const Case step({boxes("0, 0 : 1, 1; 2, 0 : 2.5, 0.5"),
                   lines("0, 0 : 3, 0; 1, 0 : 1.5, 0 : 1.5, 0.5 : 1, 0.5 : 1, 0")},
                  0.1);
  bool inside = false;
  for (const Point<2> &p : step.cloud.position)
    inside = inside || (p[0] > 1. + 1e-12 && p[0] < 1.5 - 1e-12 && p[1] > 1e-12 && p[1] < 0.5 - 1e-12);
  check("no particle inside a closed wall", !inside);
  const double step_error = step.mesh.volume(step.cloud) - 1.25;
  check("two bodies", step_error < 1e-10 && step_error > -0.03);
  check("a closed wall is closed", step.walls.facets().size() == 5);
  const std::string open_tank = "0, 2 : 0, 0 : 1.5, 0 : 1.5, 2";
  const Case in_open_tank({boxes("0, 0 : 1, 1"), lines(open_tank)}, 0.1);
  const Case in_tank({boxes("0, 0 : 1, 1"), lines(open_tank + " : 0, 2")}, 0.1);
  check("fluid in a closed wall has the volume of that between open ones",
        in_tank.mesh.volume(in_tank.cloud) - in_open_tank.mesh.volume(in_open_tank.cloud), 1e-12);
  unsigned int n_on_lid = 0;
  for (const Point<2> &p : in_tank.cloud.position)
    n_on_lid += p[1] > 2. - 1e-12;
  check("a tank has a lid", in_tank.walls.facets().size() == 4 && n_on_lid == 16);

  check_error("no fluid", {lines(walls)},
              {"no fluid", "'Fluids' and 'Solids' are empty", "'set Fluids = NAME'"});
  check_error("body below the mesh size", {boxes("0, 0 : 1, 0.05")},
              {"Mesh size", "0.1", "0.05", "fluid 'fluid'", "Allowed"});
  check_error("fluid over a wall", {boxes("0, 0 : 1, 1"), lines("0.5, -1 : 0.5, 2")},
              {"Fluid 'fluid' overlaps boundary 'walls'", "0.5"});
  check_error("fluid partly inside a closed wall",
              {boxes("0, 0 : 1, 1"), lines("0, 0 : 0.5, 0 : 0.5, 2 : 0, 2 : 0, 0")},
              {"overlaps boundary 'walls'", "0.5"});
  check_error("wall inside the fluid",
              {boxes("0, 0 : 1, 1"), lines("0, 0 : 1, 0; 0.4, 0.4 : 0.6, 0.6", "free slip")},
              {"overlaps boundary number 2 of 'walls'"});
  check_error("overlapping bodies", {boxes("0, 0 : 1, 1; 0.5, 0.5 : 2, 2")},
              {"overlaps fluid 'fluid' (number ", "number 1", "number 2"});
  check_error("the same body twice", {boxes("0, 0 : 1, 1; 0, 0 : 1, 1")}, {"overlaps fluid"});
  check_error("no number", {boxes("0, 0 : 1, x")}, {"'Fluids/fluid/box/Corners'", "1, x", "x, y : x, y"});
  check_error("three corners of a box", {boxes("0, 0 : 1, 1 : 2, 2")},
              {"'Fluids/fluid/box/Corners'", "two opposite corners"});
  check_error("bow tie", {polygons("0, 0 : 1, 1 : 1, 0 : 0, 1")},
              {"'Fluids/fluid/polygon/Corners'", "do not meet"});
  check_error("wall of one point", {boxes("0, 0 : 1, 1"), lines("0, 0", "free slip")},
              {"'Boundaries/walls/polyline/Points'", "two different points"});
  check_error("groups without a file", {fluid_of("mesh", mesh_of("", "fluid"))},
              {"'Fluids/fluid/mesh/File'", "gmsh"});
  check_error("missing file", {fluid_of("mesh", mesh_of("missing.msh", "fluid"))},
              {"missing.msh", "does not exist"});
  check_error("directory for a file", {fluid_of("mesh", mesh_of("/", "fluid"))}, {"'/'", "directory"});
  test_ranks<2>("dam and obstacle",
                {boxes("0, 0 : 1, 2"), lines("0, 3 : 0, 0 : 4, 0; 2, 0 : 2, 0.5 : 2.2, 0.5 : 2.2, 0")}, 0.05);
  return n_failed > 0;
}
