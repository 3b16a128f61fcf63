// SPDX-License-Identifier: GPL-3.0-or-later

// Test of what gmsh meshes itself: a script is the mesh that gmsh writes of it, a drawing of CAD has its volume and
// area to rounding, elements of about the size that is asked for and groups by the tags of its entities; what cannot be meshed is
// refused with gmsh's words; signals are left as they were, and no temporary file stays.

#include <lahar/geometry/gmsh_file.h>
#include <lahar/geometry/gmsh_model.h>
#include <lahar/geometry/simplex_geometry.h>

#include "../tests.h"

#include <fcntl.h>
#include <gmsh.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace Tests;

void test_script()
{
  const GmshFile<2> script(SOURCE_DIR "/column.geo"), mesh(SOURCE_DIR "/column_41.msh");
  std::vector<Point<2>> points, expected;
  std::vector<std::array<unsigned int, 3>> cells, expected_cells;
  script.cells_of("fluid", points, cells);
  mesh.cells_of("fluid", expected, expected_cells);
  double area = 0.;
  for (const auto &cell : cells)
    area += std::abs(signed_volume<2>(corners_of<2>(cell, points)));
  check("a script: area", area / (0.146 * 0.292) - 1., 1e-12);
  check("a script: groups of curves", script.facets_of("walls").size() == mesh.facets_of("walls").size());
  check("a script: its own sizes", script.mean_edge("fluid") / mesh.mean_edge("fluid") - 1., 0.05);

  const GmshFile<2> fine(SOURCE_DIR "/column.geo", 1., 0.01);
  check("a script: smaller elements", fine.mean_edge("fluid") < 0.0105);
  const GmshFile<2> in_millimetres(SOURCE_DIR "/column.geo", 1e-3, 1e-5);
  check("a script: the size counts in metres", in_millimetres.mean_edge("fluid") < 1.05e-5);
}

/// The library for drawings prints what it does; while one of these exists it is not seen.
class Silence
{
public:
  Silence()
    : screen(dup(1))
  {
    std::cout.flush();
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1);
    close(nowhere);
  }

  ~Silence()
  {
    dup2(screen, 1);
    close(screen);
  }

private:
  const int screen;
};

/// A box of 100 mm x 50 mm x 20 mm and a cylinder beside it. @param file_name with an ending in small letters.
void draw(const std::string &file_name)
{
  const Silence silence;
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::occ::addBox(0., 0., 0., 100., 50., 20.);
  gmsh::model::occ::addCylinder(200., 0., 0., 0., 0., 30., 10.);
  gmsh::model::occ::synchronize();
  gmsh::write(file_name);
  gmsh::finalize();
}

void test_drawing(const std::string &file_name, const std::string &written_as)
{
  draw(written_as);
  std::filesystem::rename(written_as, file_name);
  const GmshFile<3> drawing(file_name, 1e-3, 0.01);
  const auto volume = [&](const std::string &group) {
    std::vector<Point<3>> points;
    std::vector<std::array<unsigned int, 4>> cells;
    drawing.cells_of(group, points, cells);
    double sum = 0.;
    for (const auto &cell : cells)
      sum += std::abs(signed_volume<3>(corners_of<3>(cell, points)));
    return sum;
  };
  check(file_name + ": volume of a box", volume("1") / 1e-4 - 1., 1e-9);
  // A cylinder becomes a prism with chords of 8 to 10 mm, whose section is smaller by 1 - sin(a)/a, a < 1.
  const double cylinder = volume("2") / (numbers::PI * 1e-4 * 0.03);
  check(file_name + ": volume of a cylinder", cylinder < 1. && cylinder > 0.8);
  double area = 0.;
  for (unsigned int face = 1; face <= 6; ++face)
    for (const auto &[a, b, c] : drawing.facets_of(std::to_string(face)))
      area += cross_product_3d(b - a, c - a).norm() / 2.;
  check(file_name + ": faces of a box", area / 0.016 - 1., 1e-9);
  check(file_name + ": size of elements", std::abs(drawing.mean_edge("1") - 0.01) < 0.002);
  std::filesystem::remove(file_name);
}

void test_refused()
{
  check_throws<InputError>("a missing script", {"missing.geo", "does not exist"},
                           []() { GmshFile<2> file("missing.geo"); });
  std::ofstream("wrong.geo") << "Point(1) = {0, 0, 0;\n";
  check_throws<InputError>("a script with an error", {"wrong.geo", "line 1: syntax error"},
                           []() { GmshFile<2> file("wrong.geo"); });
  std::ofstream("empty.geo") << "h = 1;\n";
  check_throws<InputError>("a script without a geometry", {"empty.geo"},
                           []() { GmshFile<2> file("empty.geo"); });
  std::ofstream("inclined.geo")
    << "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {0, 1, 1}; Line(1) = {1, 2}; Line(2) = {2, 3};"
       "Line(3) = {3, 1}; Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};\n";
  check_throws<InputError>("a script out of the plane", {"inclined.geo", "z different from 0"},
                           []() { GmshFile<2> file("inclined.geo"); });
  draw("whole.step");
  std::string data;
  std::getline(std::ifstream("whole.step"), data, '\0');
  std::ofstream("cut.step") << data.substr(0, data.size() / 2);
  check_throws<InputError>("a drawing that ends too early", {"cut.step", "Could not read file"}, []() {
    const Silence silence;
    GmshFile<3> file("cut.step", 1., 10.);
  });
  for (const std::string name : {"wrong.geo", "empty.geo", "inclined.geo", "whole.step", "cut.step"})
    std::filesystem::remove(name);
}

int main()
{
  std::filesystem::create_directory("temporary");
  setenv("TMPDIR", "temporary", 1);
  const auto handler = std::signal(SIGINT, SIG_IGN);
  test_script();
  test_drawing("drawing.step", "drawing.step");
  test_drawing("drawing.STP", "drawing.step");
  test_drawing("drawing.brep", "drawing.brep");
  test_refused();
  check("signals are left alone", std::signal(SIGINT, handler) == SIG_IGN);
  check("temporary files are removed", std::filesystem::is_empty("temporary"));
  std::filesystem::remove("temporary");
  return n_failed;
}
