// SPDX-License-Identifier: GPL-3.0-or-later

// Test fluid, walls and solids of gmsh files in space: volume, particles on the walls, no particle twice; and the errors
// of wrong groups and of meshes of the other dimension.

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/point_set.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/solid_shape.h>
#include <lahar/utilities/factory.h>

#include "initial_case.h"

using namespace Tests;

struct Case
{
  ParticleCloud<3> cloud;
  Walls<3> walls;
  FluidMesh<3> mesh;

  Case(const Parts &parts, const double h)
  {
    const InitialGeometry<3> geometry = make_geometry<3>(parts);
    geometry.create(h, SolidContour<3>({}, cloud), cloud, walls);
    Remesher<3> remesher;
    parse(remesher);
    remesher.create_mesh(cloud, walls, {}, geometry.region(), mesh);
  }
};

void test_fluid(const std::string &name, const Parts &parts, const double h)
{
  const Case c(parts, h);
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
  Factory<SolidShape<3>>::declare_models(prm, "Shape", "mesh", "");
  prm.enter_subsection("mesh");
  for (const auto &[entry, value] : mesh_of(file, "block"))
    prm.set(entry, value);
  prm.leave_subsection();
  const auto shape = Factory<SolidShape<3>>::create_chosen(prm, "Shape");
  std::vector<Point<3>> vertices(1);
  std::vector<CellData<3>> cells;
  shape->append(0.1, 2, vertices, cells);
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

void check_error(const std::string &what, const Part &part, const std::vector<std::string> &words)
{
  check_throws<InputError>(what, words, [&]() {
    Case(part.kind == "Fluids" ? Parts{part} : Parts{boxes("0, 0, 0 : 1, 1, 1"), part}, 0.2);
  });
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string format : {"22", "41"})
  {
    const std::string file = SOURCE_DIR "/basin_" + format + ".msh";
    const auto fluid       = [&](const std::string &group) { return fluid_of("mesh", mesh_of(file, group)); };
    const auto walls = [&](const std::string &group) { return boundary_of("mesh", mesh_of(file, group)); };
    test_fluid("gmsh " + format, {fluid("fluid"), walls("floor, left wall")}, 0.2);
    test_fluid("gmsh " + format + ", one group of walls", {fluid("fluid"), walls("walls")}, 0.2);
    const Case on_floor({fluid("fluid"), walls("floor")}, 0.2);
    check("gmsh " + format + ", floor only: volume", on_floor.mesh.volume(on_floor.cloud) - 0.3, 1e-12);
    test_solid(file);

    check_error("unknown volume", fluid("water"), {file, "physical volume 'water'", "'block'", "'fluid'"});
    check_error("a surface is no volume", fluid("floor"), {"physical volume 'floor'", "'fluid'"});
    check_error("unknown surface", walls("roof"), {file, "physical surface 'roof'", "'left wall'"});
    check_throws<InputError>("a mesh in space for the plane", {file + ":", "z = 0", "'Dimension' is 2"},
                             [&]() { GmshFile<2> plane(file); });
    check_error("a plane mesh for space",
                fluid_of("mesh", mesh_of(SOURCE_DIR "/column_" + format + ".msh", "fluid")),
                {"no physical volume 'fluid'", "plane", "'Dimension' is 3"});
  }
  // Triangles far smaller than the mesh size.
  test_fluid("coarse walls",
             {boxes("0, 0, 0 : 1, 0.6, 0.5"),
              boundary_of("mesh", mesh_of(SOURCE_DIR "/basin_41.msh", "walls"))},
             0.3);
  return n_failed;
}
