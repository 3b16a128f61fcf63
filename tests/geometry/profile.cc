// SPDX-License-Identifier: GPL-3.0-or-later

// Test ground in the plane from a table, and fluid that is released on it: areas against integrals of the depth.

#include "initial_case.h"

#include <cmath>
#include <fstream>

using namespace Tests;

double hill(const double x)
{
  return 0.3 * std::exp(-2. * (x - 1.) * (x - 1.)) + 0.1 * x;
}

void write_table(const std::string &name, const double spacing, const double x0,
                 const std::function<double(const double)> &y)
{
  std::ofstream out(name);
  out.precision(17);
  for (unsigned int i = 0; i * spacing < 2. + 1e-9; ++i)
    out << x0 + i * spacing << ", " << y(i * spacing) << '\n';
}

Part ground(const std::string &file, const std::string &law = "free slip", const Entries &more = {})
{
  Entries all = more;
  all.emplace_back("File", file);
  return boundary_of("terrain", all, law, "ground");
}

Part release(const Entries &entries)
{
  Entries all = entries;
  all.emplace_back("Boundary", "ground");
  return fluid_of("release", all);
}

double area_of(const Entries &entries, const Part &on)
{
  return make_geometry<2>({release(entries), on}).fluid_volume();
}

void test_profile()
{
  write_table("ground.csv", 0.1, 0., hill);
  const auto facets = [](const Part &on) {
    return make_geometry<2>({boxes("5, 5 : 6, 6"), on}).walls_at(0.);
  };
  double off         = 0.;
  const Walls<2> all = facets(ground("ground.csv"));
  for (const WallFacet<2> &facet : all.facets())
    for (const Point<2> &p : facet.corners)
      off = std::max(off, std::abs(p[1] - hill(p[0])));
  check("a table gives a line through its points", all.facets().size() == 20 && off < 1e-14);
  const Walls<2> part = facets(
    ground("ground.csv", "free slip", {{"Window", "0.5, 1.7"}, {"Spacing", "0.25"}}));
  check("a window at a spacing", part.facets().size() == 5 && part.facets()[0].corners[0][0] == 0.5);
  check("linear between the rows",
        part.facets()[0].corners[1].distance(Point<2>(0.74, 0.6 * hill(0.7) + 0.4 * hill(0.8))), 1e-14);
  write_table("far.csv", 0.1, 3e5, hill);
  const Walls<2> moved = facets(ground("far.csv", "free slip", {{"Origin", "3e5, 0.1"}}));
  check("an origin is subtracted",
        moved.facets()[3].corners[0].distance(all.facets()[3].corners[0] - Tensor<1, 2>({0., 0.1})), 1e-9);
}

void test_release()
{
  check("a depth between ends",
        area_of({{"Depth", "0.2"}, {"Ends", "0.43, 1.51"}}, ground("ground.csv")) / 0.216 - 1., 1e-12);
  std::vector<double> errors;
  for (const double spacing : {0.1, 0.05})
  {
    write_table("bowl.csv", spacing, -1., [](const double x) { return (x - 1.) * (x - 1.); });
    errors.push_back(area_of({{"Level", "0.49"}}, ground("bowl.csv")) / (4. / 3. * std::pow(0.7, 3)) - 1.);
  }
  check("a level in a bowl", errors.back(), 2e-3);
  check("of second order", std::log2(errors[0] / errors[1]) > 1.8);
  std::ofstream("depth.csv") << "0.4, 0\n0.9, 0.2\n1.3, 0.1\n1.6, 0\n";
  const double depths = 0.5 * 0.5 * 0.2 + 0.4 * 0.15 + 0.3 * 0.5 * 0.1;
  check("a table of depths", area_of({{"Depth file", "depth.csv"}}, ground("ground.csv")) / depths - 1.,
        1e-12);
  errors.clear();
  for (const double h : {0.04, 0.02})
    for (const std::string law : {"free slip", "no slip"})
    {
      write_table("ground.csv", h, 0., hill);
      const InitialCase<2> c({release({{"Depth file", "depth.csv"}}), ground("ground.csv", law)}, h);
      errors.push_back(c.mesh.volume(c.cloud) / depths - 1.);
    }
  check("first mesh, free slip", errors[2], 0.01);
  check("first mesh, no slip", errors[3], 0.01);
  const InitialCase<2> block({release({{"Depth", "0.2"}, {"Ends", "0.4, 1.4"}}), ground("ground.csv")}, 0.02);
  check("first mesh of a block", block.mesh.volume(block.cloud) / 0.2 - 1., 1e-3);
  if (n_failed > 0)
    for (const double error : errors)
      std::cout << error << ' ' << block.mesh.volume(block.cloud) / 0.2 - 1. << std::endl;
}

void test_wrong_input()
{
  const auto refused = [](const std::string &what, const Entries &entries, const Part &on,
                          const std::vector<std::string> &words) {
    check_throws<InputError>(what, words, [&]() { area_of(entries, on); });
  };
  const std::string path = "'Fluids/fluid/release/", terrain = "'Boundaries/ground/terrain/";
  const Entries block = {{"Depth", "0.2"}, {"Ends", "0.4, 1.4"}};
  refused("no table", block, ground(""), {terrain + "File'", ".csv"});
  std::ofstream("back.csv") << "0, 1\n1, 1\n0.5, 2\n";
  refused("a table that turns back", block, ground("back.csv"), {"back.csv:3", "0.5, 2", "larger x"});
  std::ofstream("one.csv") << "0, 1\n";
  refused("one point", block, ground("one.csv"), {"one.csv", "at least two"});
  refused("a window beyond the table", block, ground("ground.csv", "free slip", {{"Window", "0, 3"}}),
          {terrain + "Window'", "0, 3", "from 0 to 2"});
  refused("no depth", {{"Ends", "0, 1"}}, ground("ground.csv"), {path + "Depth'", "'Level'"});
  refused("no ends", {{"Depth", "1"}}, ground("ground.csv"), {path + "Ends'", "x0 < x1"});
  refused("ends beyond the ground", {{"Depth", "1"}, {"Ends", "1, 3"}}, ground("ground.csv"),
          {path + "Ends'", "1, 3"});
  refused("a level below the ground", {{"Level", "-1"}}, ground("ground.csv"),
          {"Fluids/fluid/release", "no fluid"});
  std::ofstream("negative.csv") << "0, 1\n1, -1\n";
  refused("a negative depth", {{"Depth file", "negative.csv"}}, ground("ground.csv"),
          {"negative.csv:2", "zero or above"});
  check_throws<InputError>(
    "fluid that is flat for the mesh", {"'Mesh size' is 0.1", "'Fluids/fluid/release'", "0.02 m deep"}, []() {
      InitialCase<2>({release({{"Depth", "0.02"}, {"Ends", "0.4, 1.4"}}), ground("ground.csv")}, 0.1);
    });
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_profile();
  test_release();
  test_wrong_input();
  return n_failed;
}
