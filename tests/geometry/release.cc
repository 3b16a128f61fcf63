// SPDX-License-Identifier: GPL-3.0-or-later

// Test fluid that is released on terrain: the volume of the body and of the first mesh against integrals of the depth, their
// order of convergence, particles on the ground and on the surface, and wrong input.

#include <lahar/geometry/simplex_geometry.h>

#include "hill.h"
#include "initial_case.h"

#include <algorithm>
#include <sstream>

using namespace Tests;

double hill(const double x, const double y)
{
  return 0.3 * std::exp(-2. * ((x - 1.) * (x - 1.) + (y - 0.8) * (y - 0.8))) + 0.1 * x;
}

/// A cap of fluid, 0.2 m deep, with a rim where depth is zero.
double cap(const double x, const double y)
{
  return std::max(0., 0.2 * (1. - ((x - 0.9) * (x - 0.9) + (y - 0.7) * (y - 0.7)) / 0.25));
}

Grid grid_of(const std::function<double(const double, const double)> &z, const double spacing)
{
  Grid grid;
  grid.spacing = spacing;
  grid.nx      = std::lround(2. / spacing) + 1;
  grid.ny      = std::lround(1.6 / spacing) + 1;
  grid.z       = z;
  return grid;
}

Part release(const Entries &entries)
{
  Entries all = entries;
  all.emplace_back("Boundary", "ground");
  return fluid_of("release", all);
}

Part ground(const std::string &file, const std::string &law = "free slip", const Entries &more = {})
{
  Entries all = more;
  all.emplace_back("File", file);
  return boundary_of("terrain", all, law, "ground");
}

/// Volume of the body.
double body_volume(const Entries &entries, const Part &on)
{
  return make_geometry<3>({release(entries), on}).fluid_volume();
}

double order(const std::vector<double> &errors, const double ratio)
{
  return std::log(std::abs(errors.front() / errors.back())) / std::log(std::pow(ratio, errors.size() - 1.));
}

std::string to_text(const std::vector<double> &values)
{
  std::ostringstream text;
  for (const double value : values)
    text << ' ' << value;
  return text.str();
}

void test_bodies()
{
  // ∫ depth of the cap = π R² d/2.
  const double volume = 0.5 * numbers::PI * 0.25 * 0.2;
  std::vector<double> errors, bowl_errors;
  for (const double spacing : {0.1, 0.05, 0.025})
  {
    grid_of(hill, spacing).write_asc("ground.asc");
    grid_of(cap, spacing).write_asc("depth.asc");
    errors.push_back(body_volume({{"Depth file", "depth.asc"}}, ground("ground.asc")) / volume - 1.);
    // A bowl z = x² + y² up to the level L: ∫ (L − z) = π L²/2.
    Grid bowl = grid_of([](const double x, const double y) { return x * x + y * y; }, spacing);
    bowl.x0   = -1.;
    bowl.y0   = -0.8;
    bowl.write_asc("bowl.asc");
    bowl_errors.push_back(
      body_volume({{"Level", "0.35"}}, ground("bowl.asc")) / (0.5 * numbers::PI * 0.35 * 0.35) - 1.);
  }
  check("a raster of depths: volume", errors.back(), 1e-3);
  check("of second order", order(errors, 2.) > 1.8);
  check("a level in a bowl: volume", bowl_errors.back(), 4e-3);
  check("of second order", order(bowl_errors, 2.) > 1.8);
  if (n_failed)
    std::cout << to_text(errors) << to_text(bowl_errors) << std::endl;

  grid_of(hill, 0.1).write_asc("ground.asc");
  const std::string triangle = "0.43, 0.37 : 1.52, 0.61 : 0.84, 1.33";
  const double area          = 0.5 * ((1.52 - 0.43) * (1.33 - 0.37) - (0.61 - 0.37) * (0.84 - 0.43));
  check("a depth within an outline: area times depth",
        body_volume({{"Depth", "0.2"}, {"Outline", triangle}}, ground("ground.asc")) / (0.2 * area) - 1.,
        1e-9);
  check("an outline that is not convex",
        body_volume({{"Depth", "0.2"}, {"Outline", "0.4, 0.4 : 1.6, 0.4 : 1.6, 1.2 : 1, 0.6 : 0.4, 1.2"}},
                    ground("ground.asc")) /
            (0.2 * (0.96 - 0.5 * 1.2 * 0.6)) -
          1.,
        1e-9);
  check("two outlines",
        body_volume({{"Depth", "0.2"},
                     {"Outline",
                      "0.2, 0.2 : 0.7, 0.2 : 0.7, 0.7 : 0.2, 0.7; 1.1, 0.9 : 1.6, 0.9 : 1.6, 1.3"}},
                    ground("ground.asc")) /
            (0.2 * (0.25 + 0.1)) -
          1.,
        1e-9);
  std::ofstream("outline.csv") << "# x, y\n0.43, 0.37\n1.52, 0.61\n0.84, 1.33\n0.43, 0.37\n";
  check("an outline from a table, closed",
        body_volume({{"Depth", "0.2"}, {"Outline file", "outline.csv"}}, ground("ground.asc")) /
            (0.2 * area) -
          1.,
        1e-9);
  const unsigned int n = 1000;
  std::ofstream circle("circle.csv");
  circle.precision(17);
  for (unsigned int i = 0; i < n; ++i)
    circle << 1. + 0.5 * std::cos(2. * numbers::PI * i / n) << ", "
           << 0.8 + 0.5 * std::sin(2. * numbers::PI * i / n) << '\n';
  circle.close();
  check("an outline of a thousand corners",
        body_volume({{"Depth", "0.2"}, {"Outline file", "circle.csv"}}, ground("ground.asc")) /
            (0.2 * 0.5 * n * 0.25 * std::sin(2. * numbers::PI / n)) -
          1.,
        1e-6);
  Grid far = grid_of([](const double x, const double y) { return 900. + hill(x - 4.2e5, y - 5.1e6); }, 0.1);
  far.x0   = 4.2e5;
  far.y0   = 5.1e6;
  far.write_asc("far.asc");
  check("an outline in coordinates of a map",
        body_volume({{"Depth", "0.2"},
                     {"Outline", "420000.43, 5100000.37 : 420001.52, 5100000.61 : 420000.84, 5100001.33"}},
                    ground("far.asc", "free slip", {{"Origin", "420000, 5100000, 900"}})) /
            (0.2 * area) -
          1.,
        1e-7);
  const double all  = body_volume({{"Level", "0.35"}}, ground("bowl.asc"));
  const double half = body_volume({{"Level", "0.35"}, {"Outline", "0, -0.8 : 1, -0.8 : 1, 0.8 : 0, 0.8"}},
                                  ground("bowl.asc"));
  check("a level within an outline", half / all - 0.5, 1e-9);
}

void test_meshes()
{
  const double volume = 0.5 * numbers::PI * 0.25 * 0.2;
  std::vector<double> errors;
  for (const double h : {0.1, 0.05})
  {
    grid_of(hill, h).write_asc("ground.asc");
    grid_of(cap, h).write_asc("depth.asc");
    const InitialCase<3> c({release({{"Depth file", "depth.asc"}}), ground("ground.asc")}, h);
    errors.push_back(c.mesh.volume(c.cloud) / volume - 1.);
  }
  check("a cap: volume of the first mesh", errors.back(), 0.01);
  check("of second order", order(errors, 2.) > 1.8);

  // A block of constant depth, with steep sides.
  grid_of(hill, 0.05).write_asc("ground.asc");
  const Entries block = {{"Depth", "0.2"}, {"Outline", "0.5, 0.4 : 1.3, 0.4 : 1.3, 1.1 : 0.5, 1.1"}};
  for (const std::string law : {"free slip", "no slip", "wall particles"})
  {
    const double h = 0.06;
    const InitialCase<3> c({release(block), ground("ground.asc", law)}, h);
    check("a block, " + law + ": volume of the first mesh", c.mesh.volume(c.cloud) / (0.2 * 0.8 * 0.7) - 1.,
          1e-4);
    unsigned int n_ground = 0, n_surface = 0, n_below = 0;
    for (unsigned int i = 0; i < c.cloud.size(); ++i)
    {
      const Point<3> &p = c.cloud.position[i];
      if (c.cloud.kind[i] == ParticleKind::wall)
        continue;
      const double above = p[2] - hill(p[0], p[1]);
      n_ground += std::abs(above) < 0.004;
      n_surface += std::abs(above - 0.2) < 0.004;
      n_below += above < -0.004;
    }
    const double n = 0.8 * 0.7 / (std::sqrt(0.75) * h * h);
    check("particles of the surface", n_surface > 0.8 * n && n_surface < 1.5 * n);
    check("particles on the ground",
          law == "wall particles" ? n_ground == 0 : n_ground > 0.8 * n && n_ground < 1.5 * n);
    check("none below", n_below == 0);
  }
}

void test_wrong_input()
{
  const auto refused = [](const std::string &what, const Entries &entries,
                          const std::vector<std::string> &words) {
    check_throws<InputError>(what, words, [&]() { body_volume(entries, ground("ground.asc")); });
  };
  const std::string path = "'Fluids/fluid/release/", square = "0.5, 0.5 : 1, 0.5 : 1, 1 : 0.5, 1";
  refused("no depth", {{"Outline", square}}, {path + "Depth'", "'Depth file' and 'Level'"});
  refused("two depths", {{"Depth", "1"}, {"Level", "1"}}, {path + "Depth'", "not more"});
  refused("a depth without outline", {{"Depth", "1"}}, {path + "Outline'", "polygons"});
  refused("an outline beyond the terrain", {{"Depth", "1"}, {"Outline", "0.5, 0.5 : 3, 0.5 : 1, 1"}},
          {path + "Outline'", "found 3 0.5", "to (2 1.6)"});
  refused("an outline that crosses itself", {{"Depth", "1"}, {"Outline", "0, 0 : 1, 1 : 1, 0 : 0, 1"}},
          {path + "Outline'", "edges that do not meet"});
  refused("two kinds of outline", {{"Depth", "1"}, {"Outline", square}, {"Outline file", "outline.csv"}},
          {path + "Outline file'", "not both"});
  refused("a level below the ground", {{"Level", "-1"}}, {"'Fluids/fluid/release'", "no fluid", "'Level'"});
  refused("a level that is no number", {{"Level", "high"}}, {path + "Level'", "high", "elevation"});
  refused("a missing raster", {{"Depth file", "nowhere.asc"}}, {"nowhere.asc", "does not exist"});
  grid_of([](const double, const double) { return -0.1; }, 0.1).write_asc("negative.asc");
  refused("negative depths", {{"Depth file", "negative.asc"}},
          {path + "Depth file'", "-0.1 m at", "zero or above"});
  Grid beside = grid_of(cap, 0.1);
  beside.x0   = 1.;
  beside.z    = [](const double x, const double) { return x > 2.5 ? 1. : 0.; };
  beside.write_asc("beside.asc");
  refused("depths beyond the terrain", {{"Depth file", "beside.asc"}},
          {path + "Depth file'", "found 1 m at", "2 1.6"});
  check_throws<InputError>("no boundary", {path + "Boundary'", "'Shape' is 'terrain'", "'ground'"}, []() {
    make_geometry<3>({fluid_of("release", {{"Depth", "1"}, {"Boundary", "floor"}}), ground("ground.asc")});
  });
  check_throws<InputError>("a boundary of another shape", {path + "Boundary'", "there is none"}, []() {
    make_geometry<3>(
      {fluid_of("release", {{"Depth", "1"}, {"Boundary", "walls"}}), planes("0, 0, 0 : 1, 0, 0 : 1, 1, 0")});
  });
  check_throws<InputError>(
    "fluid that is flat for the mesh", {"'Mesh size' is 0.1", "0.02 m deep", "release"}, [&]() {
      InitialCase<3>({release({{"Depth", "0.02"}, {"Outline", square}}), ground("ground.asc")}, 0.1);
    });
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_bodies();
  test_meshes();
  test_wrong_input();
  return n_failed;
}
