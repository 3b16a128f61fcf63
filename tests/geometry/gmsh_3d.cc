// SPDX-License-Identifier: GPL-3.0-or-later

// Test fluid, walls and solids of gmsh files in space: volume, particles on the walls, no particle twice; and the errors
// of wrong groups and of meshes of the other dimension.

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/initial_geometry.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/solid_shape.h>
#include <lahar/remeshing/remesher.h>
#include <lahar/remeshing/simplex_geometry.h>

#include "tests.h"

using namespace Tests;

struct Case
{
  ParticleCloud<3> cloud;
  Walls<3> walls;
  FluidMesh<3> mesh;

  Case(const Entries &entries, const double h)
  {
    Parameters prm;
    InitialGeometry<3>::declare_parameters(prm);
    prm.enter_subsection("Geometry");
    for (const auto &[entry, value] : entries)
      prm.set(entry, value);
    prm.leave_subsection();
    InitialGeometry<3> geometry;
    geometry.parse_parameters(prm, false);
    geometry.create(h, SolidContour<3>({}, cloud), cloud, walls);
    Remesher<3> remesher;
    parse(remesher);
    remesher.create_mesh(cloud, walls, {}, geometry.region(), mesh);
  }
};

void test_fluid(const std::string &name, const Entries &entries, const double h)
{
  const Case c(entries, h);
  // Tetrahedra with corners on floor and wall only are no fluid: a prism h × h/2 along their edge at most.
  const double missing = 0.3 - c.mesh.volume(c.cloud);
  check(name + ": volume", missing > 0. && missing < 0.5 * h * h * 0.6);
  double area = 0.;
  for (const WallFacet<3> &facet : c.walls.facets())
    area += 0.5 *
            cross_product_3d(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]).norm();
  check(name + ": area of the walls", area - (1.6 + 0.8) * 0.6, 1e-12);

  PointSet<3> places;
  bool on_walls = true, inside = true, apart = true;
  unsigned int n_beside = 0;
  for (unsigned int i = 0; i < c.cloud.size(); ++i)
  {
    const Point<3> &p = c.cloud.position[i];
    apart             = apart && places.insert_if_free(p, 0.3 * h);
    if (c.cloud.kind[i] == ParticleKind::wall)
    {
      on_walls = on_walls && (std::abs(p[0]) < 1e-12 || std::abs(p[2]) < 1e-12);
      n_beside += p[0] > 1. + 1e-12 || p[2] > 0.5 + 1e-12;
    }
    else
      inside = inside && p[0] > 0.3 * h && p[2] > 0.3 * h && p[0] < 1. + 1e-12 && p[2] < 0.5 + 1e-12;
  }
  check(name + ": particles keep their distance", apart);
  check(name + ": wall particles lie on the walls, fluid beside them", on_walls && inside);
  const double expected = 0.54 / (std::sqrt(0.75) * h * h);
  check(name + ": particles of the walls beside the fluid", n_beside > expected && n_beside < 2. * expected);
}

void test_solid(const std::string &file)
{
  Parameters prm;
  SolidShape<3>::declare_parameters(prm);
  prm.set("Mesh file", file);
  prm.set("Group", "block");
  SolidShape<3> shape;
  shape.parse_parameters(prm);
  std::vector<Point<3>> vertices(1);
  std::vector<CellData<3>> cells;
  shape.append(0.1, 2, vertices, cells);
  double volume = 0.;
  bool positive = true;
  for (const CellData<3> &cell : cells)
  {
    SimplexCorners<3> corners;
    for (unsigned int c = 0; c < 4; ++c)
      corners[c] = vertices.at(cell.vertices.at(c));
    volume += signed_volume<3>(corners);
    positive = positive && signed_volume<3>(corners) > 0. && cell.material_id == 2;
  }
  check("solid: volume", volume - 0.016, 1e-12);
  check("solid: orientation and number of the body", positive);
}

void check_error(const std::string &what, const Entries &entries, const std::vector<std::string> &parts)
{
  check_throws<InputError>(what, parts, [&]() { Case(entries, 0.2); });
}

int main()
{
  for (const std::string format : {"22", "41"})
  {
    const std::string file = SOURCE_DIR "/basin_" + format + ".msh";
    const Entries fluid    = {{"Mesh file", file}, {"Fluid groups", "fluid"}};
    Entries entries        = fluid;
    entries.emplace_back("No-slip wall groups", "floor, left wall");
    test_fluid("gmsh " + format, entries, 0.2);
    entries.back().second = "walls";
    test_fluid("gmsh " + format + ", one group of walls", entries, 0.2);
    entries.back().second = "floor";
    const Case on_floor(entries, 0.2);
    check("gmsh " + format + ", floor only: volume", on_floor.mesh.volume(on_floor.cloud) - 0.3, 1e-12);
    test_solid(file);

    entries               = fluid;
    entries.back().second = "water";
    check_error("unknown volume", entries, {file, "physical volume 'water'", "'block'", "'fluid'"});
    entries.back().second = "floor";
    check_error("a surface is no volume", entries, {"physical volume 'floor'", "'fluid'"});
    entries = fluid;
    entries.emplace_back("Slip wall groups", "roof");
    check_error("unknown surface", entries, {file, "physical surface 'roof'", "'left wall'"});
    check_throws<InputError>("a mesh in space for the plane", {file + ":", "z = 0", "'Dimension' is 2"},
                             [&]() { GmshFile<2> plane(file); });
    check_error("a plane mesh for space",
                {{"Mesh file", SOURCE_DIR "/column_" + format + ".msh"}, {"Fluid groups", "fluid"}},
                {"no physical volume 'fluid'", "plane", "'Dimension' is 3"});
  }
  // Triangles far smaller than the mesh size.
  test_fluid("coarse walls",
             {{"Fluid boxes", "0, 0, 0 : 1, 0.6, 0.5"},
              {"Mesh file", SOURCE_DIR "/basin_41.msh"},
              {"No-slip wall groups", "walls"}},
             0.3);
  return n_failed;
}
