// SPDX-License-Identifier: GPL-3.0-or-later

// Test that one mesh in all formats of gmsh's that are read (ASCII and binary, of first and second order) has the same
// fluid and the same walls; groups by tags and by names with commas; the factor for lengths; and that files which end
// too early or have wrong bytes are refused.

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/simplex_geometry.h>

#include "../tests.h"

#include <fstream>

using namespace Tests;

std::string read(const std::string &name)
{
  std::ifstream in(SOURCE_DIR "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

template <int dim>
void test_same(const std::string &name, const std::string &other)
{
  const GmshFile<dim> file(SOURCE_DIR "/" + name), ascii(SOURCE_DIR "/" + other);
  std::vector<Point<dim>> points, expected;
  std::vector<std::array<unsigned int, dim + 1>> cells, expected_cells;
  file.cells_of("fluid", points, cells);
  ascii.cells_of("fluid", expected, expected_cells);
  double error = points.size() == expected.size() ? 0. : 1.;
  for (unsigned int i = 0; i < points.size() && error < 1.; ++i)
    error = std::max(error, points[i].distance(expected[i]));
  check(name + ": nodes", error, 1e-12);
  check(name + ": cells", cells == expected_cells);
  for (const std::string group : {"floor", "left wall", "walls"})
  {
    const auto &facets = file.facets_of(group), &expected_facets = ascii.facets_of(group);
    double distance = facets.size() == expected_facets.size() ? 0. : 1.;
    for (unsigned int f = 0; f < facets.size() && distance < 1.; ++f)
      for (unsigned int v = 0; v < dim; ++v)
        distance = std::max(distance, facets[f][v].distance(expected_facets[f][v]));
    check(name + ": facets of '" + group + "'", distance, 1e-12);
  }

  const GmshFile<dim> in_millimetres(SOURCE_DIR "/" + name, 1e-3);
  check(name + ": scale", in_millimetres.mean_edge("fluid") / ascii.mean_edge("fluid") - 1e-3, 1e-12);
}

/// @p data is refused with the name of its file.
template <int dim>
bool is_refused(const std::string &data, const std::string &part = "")
{
  std::ofstream("damaged.msh", std::ios::binary) << data;
  try
  {
    GmshFile<dim> file("damaged.msh");
    return false;
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    return message.find("damaged.msh:") == 0 && message.find(part) != std::string::npos;
  }
}

template <int dim>
void test_damaged(const std::string &name)
{
  const std::string data = read(name);
  bool refused           = true;
  for (unsigned int k = 0; k < 40; ++k)
    refused = refused && is_refused<dim>(data.substr(0, (data.size() - 20) * k / 40));
  check(name + ": a truncated file is refused", refused);

  // What is accepted has all its parts.
  Random random;
  bool sound = true;
  for (unsigned int k = 0; k < 200; ++k)
  {
    std::string changed = data;
    for (unsigned int j = 0; j < 4; ++j)
      changed[(random.number() + 1.) / 2. * (data.size() - 1)] = 127. * random.number();
    std::ofstream("damaged.msh", std::ios::binary) << changed;
    try
    {
      const GmshFile<dim> file("damaged.msh");
      std::vector<Point<dim>> points;
      std::vector<std::array<unsigned int, dim + 1>> cells;
      file.cells_of("fluid", points, cells);
      for (const Point<dim> &point : points)
        sound = sound && std::isfinite(point.norm());
    }
    catch (const InputError &)
    {}
  }
  check(name + ": changed bytes", sound);
}

void test_groups()
{
  const GmshFile<2> file(SOURCE_DIR "/groups_41.msh");
  check("a group by a name with a comma", file.nodes_of("water, at rest") == file.nodes_of("fluid"));
  check("a group without a name by its tag", file.facets_of("7") == file.facets_of("floor"));
  check("a group with a name by its tag", file.facets_of("3") == file.facets_of("left wall"));
  check_throws<InputError>("an unknown tag", {"'8'", "'floor'", "7 (has no name)"},
                           [&]() { file.facets_of("8"); });
  check_throws<InputError>("a tag of the other dimension", {"'7'", "'water, at rest'"},
                           [&]() { file.nodes_of("7"); });
}

int main()
{
  for (const std::string name : {"column_22.msh", "column_22_binary.msh", "column_40.msh",
                                 "column_41_binary.msh", "column_41_quadratic.msh"})
    test_same<2>(name, "column_41.msh");
  for (const std::string name : {"basin_22.msh", "basin_22_quadratic.msh", "basin_41_binary.msh"})
    test_same<3>(name, "basin_41.msh");
  for (const std::string name : {"column_22_binary.msh", "column_40.msh", "column_41_binary.msh"})
    test_damaged<2>(name);
  test_damaged<3>("basin_22_quadratic.msh");
  test_groups();

  std::string data = read("column_41_binary.msh");
  std::reverse(data.begin() + data.find('\n', 14) + 1, data.begin() + data.find('\n', 14) + 5);
  check("another order of bytes", is_refused<2>(data, "order of bytes"));
  check("binary format 4.0, which gmsh does not write",
        is_refused<2>("$MeshFormat\n4 1 8\n\1\0\0\0", "format 4.1"));
  check("an old format", is_refused<2>("$MeshFormat\n1 0 8\n$EndMeshFormat\n", "2.2, 4.0 and 4.1"));
  return n_failed;
}
