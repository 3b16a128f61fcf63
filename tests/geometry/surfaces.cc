// SPDX-License-Identifier: GPL-3.0-or-later

// Test boundaries from drawings: what is mended and said (turned faces, holes, faces without area), what is refused
// (faces that cross, wrong files), the factor of length, and new triangles at a wanted size.

#include "hill.h"
#include "initial_case.h"

#include <lahar/geometry/surface_file.h>

#include <algorithm>

using namespace Tests;

using Triangles = std::vector<std::array<Point<3>, 3>>;

/// A box [0, 1]³ scaled by @p size, n × n squares of two triangles a side, outwards.
Triangles box_surface(const unsigned int n, const double size = 1.)
{
  Triangles result;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int side = 0; side < 2; ++side)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          const auto node = [&](const unsigned int a, const unsigned int b) {
            Point<3> p;
            p[d]           = side * size;
            p[(d + 1) % 3] = a * size / n;
            p[(d + 2) % 3] = b * size / n;
            return p;
          };
          std::array<Point<3>, 3> first  = {{node(i, j), node(i + 1, j), node(i + 1, j + 1)}},
                                  second = {{node(i, j), node(i + 1, j + 1), node(i, j + 1)}};
          if (side == 0)
          {
            std::swap(first[1], first[2]);
            std::swap(second[1], second[2]);
          }
          result.push_back(first);
          result.push_back(second);
        }
  return result;
}

double area_of(const Triangles &triangles)
{
  double sum = 0.;
  for (const auto &[a, b, c] : triangles)
    sum += 0.5 * cross_product_3d(b - a, c - a).norm();
  return sum;
}

/// Volume if all triangles are turned outwards.
double volume_of(const Triangles &triangles)
{
  double sum = 0.;
  for (const auto &[a, b, c] : triangles)
    sum += cross_product_3d(Tensor<1, 3>(a), Tensor<1, 3>(b)) * Tensor<1, 3>(c) / 6.;
  return sum;
}

Triangles read(const std::string &file, const Triangles &triangles, std::vector<std::string> &remarks,
               const double scale = 1., const double spacing = 0.)
{
  file.substr(file.size() - 3) == "stl" ? write_stl(file, triangles) : write_indexed(file, triangles);
  const SurfaceFile surface(file, scale, spacing, "Spacing");
  remarks = surface.remarks();
  return surface.triangles();
}

bool says(const std::vector<std::string> &remarks, const std::string &file, const std::string &text)
{
  return std::count_if(remarks.begin(), remarks.end(), [&](const std::string &remark) {
           return remark.find(text) != std::string::npos && remark.find(file) != std::string::npos;
         }) == 1;
}

void test_mending()
{
  std::vector<std::string> remarks;
  const Triangles box = box_surface(8);
  for (const std::string file : {"box.stl", "box.obj", "box.ply"})
  {
    const Triangles same = read(file, box, remarks);
    check(file + ": a sound box", same.size() == box.size() && remarks.empty());
    check(file + ": area and volume", std::abs(area_of(same) - 6.) + std::abs(std::abs(volume_of(same)) - 1.),
          1e-12);
  }
  check("a factor of length", std::abs(volume_of(read("box.stl", box_surface(2, 1000.), remarks, 1e-3))) - 1.,
        1e-12);

  Triangles turned = box;
  for (const unsigned int i : {3, 40, 41, 200})
    std::swap(turned[i][0], turned[i][1]);
  const Triangles turned_back = read("turned.stl", turned, remarks);
  check("turned faces are turned back", std::abs(volume_of(turned_back)) - 1., 1e-12);
  check("and said", says(remarks, "turned.stl", "4 faces were turned over"));

  Triangles open = box_surface(40);
  open.erase(open.begin() + 10);
  const Triangles closed = read("open.stl", open, remarks);
  // Of 19200 triangles, hence the rounding.
  check("a hole is closed", std::abs(area_of(closed) - 6.) + std::abs(std::abs(volume_of(closed)) - 1.),
        1e-11);
  check("and said", says(remarks, "open.stl", "1 holes were closed"));
  open.assign(box.begin() + 2 * 64, box.end());
  check("an open side stays", area_of(read("side.stl", open, remarks)) - 5., 1e-12);
  check("without a word: it is longer than the diagonal", remarks.empty());
  open = box;
  open.erase(open.begin() + 10, open.begin() + 12);
  read("gap.stl", open, remarks);
  check("a shorter gap is said", says(remarks, "gap.stl", "rims of 0.5 m"));

  Triangles flat = box;
  flat.push_back({{box[0][0], box[0][1], box[0][0] + 0.5 * (box[0][1] - box[0][0])}});
  flat.push_back(box[7]);
  check("faces without area and twice there go", read("flat.stl", flat, remarks).size() == box.size());
  check("and this is said", says(remarks, "flat.stl", "2 faces"));
}

/// A rectangle x × [0, 1] × [0, top] of n × n squares in two triangles each.
Triangles plate(const double x, const double top, const unsigned int n)
{
  Triangles result;
  const auto node = [&](const unsigned int i, const unsigned int j) {
    return Point<3>(x, double(i) / n, double(j) / n * top);
  };
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      result.push_back({{node(i, j), node(i + 1, j), node(i + 1, j + 1)}});
      result.push_back({{node(i, j), node(i + 1, j + 1), node(i, j + 1)}});
    }
  return result;
}

void test_joints()
{
  // Edges with three and four faces.
  std::vector<std::string> remarks;
  Triangles tank = box_surface(4);
  for (const auto &triangle : plate(0.5, 1., 4))
    tank.push_back(triangle);
  check("a wall through a box", area_of(read("wall.stl", tank, remarks)) - 7., 1e-12);
  check("without a word: it joins on all sides", remarks.empty());
  const Triangles fine = read("wall.stl", tank, remarks, 1., 0.08);
  check("with new triangles", area_of(fine) - 7., 1e-9);
  check("of the wanted size", std::sqrt(7. / (0.43 * fine.size())) / 0.08 - 1., 0.25);

  tank.resize(6 * 2 * 16);
  for (const auto &triangle : plate(0.5, 1., 4))
    if (std::max({triangle[0][2], triangle[1][2], triangle[2][2]}) < 0.6)
      tank.push_back(triangle);
  check("a baffle that ends below the lid", area_of(read("baffle.stl", tank, remarks)) - 6.5, 1e-12);
  check("its free edge is said", says(remarks, "baffle.stl", "rims of 1 m"));

  Triangles boxes = box_surface(4);
  for (auto triangle : box_surface(4))
  {
    for (Point<3> &p : triangle)
      p += Point<3>(1., 1., 0.) - Point<3>();
    boxes.push_back(triangle);
  }
  check("two boxes with a common edge", area_of(read("boxes.stl", boxes, remarks)) - 12., 1e-12);
  check("without a word: they are closed", remarks.empty());
}

void test_new_triangles()
{
  std::vector<std::string> remarks;
  const Triangles box = box_surface(1);
  for (const double spacing : {0.1, 0.25})
  {
    const Triangles fine = read("coarse.stl", box, remarks, 1., spacing);
    check("new triangles keep the edges of a box", std::abs(std::abs(volume_of(fine)) - 1.), 1e-9);
    double mean = 0.;
    for (const auto &[a, b, c] : fine)
      mean += (a.distance(b) + b.distance(c) + c.distance(a)) / (3. * fine.size());
    check("and have the wanted size", mean / spacing - 1., 0.2);
  }
  // A sphere of many triangles becomes coarser: area of second order.
  std::vector<double> errors;
  const Triangles cube = box_surface(32, 2.);
  Triangles sphere     = cube;
  for (auto &triangle : sphere)
    for (Point<3> &p : triangle)
    {
      const Tensor<1, 3> r = p - Point<3>(1., 1., 1.);
      p                    = Point<3>(r / r.norm());
    }
  for (const double spacing : {0.4, 0.2})
    errors.push_back(area_of(read("sphere.stl", sphere, remarks, 1., spacing)) / (4. * numbers::PI) - 1.);
  check("a sphere of coarse triangles: area", errors.back(), 0.02);
  check("of second order", std::log2(errors[0] / errors[1]) > 1.6);
}

void test_wrong_input()
{
  const auto refused = [](const std::string &what, const std::string &file,
                          const std::vector<std::string> &words, const double spacing = 0.) {
    check_throws<InputError>(what, words, [&]() { SurfaceFile(file, 1., spacing, "Spacing"); });
  };
  refused("a missing file", "nowhere.stl", {"nowhere.stl", "does not exist", "STL, OBJ, PLY"});
  std::ofstream("text.stl") << "no surface at all\n";
  refused("no surface", "text.stl", {"text.stl", "Allowed"});
  std::ofstream("empty.stl") << "solid a\nendsolid a\n";
  refused("a surface without triangles", "empty.stl", {"empty.stl", "no triangles"});
  std::ofstream("nan.stl")
    << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 nan\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid a\n";
  refused("a point that is not finite", "nan.stl", {"nan.stl", "Allowed"});
  std::ofstream("far.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n";
  refused("a face with a point that is not there", "far.obj", {"far.obj", "Allowed"});
  write_stl("box.stl", box_surface(2));
  std::ofstream("box.vrml") << "box\n";
  refused("a kind that is not known", "box.vrml", {"box.vrml", "STL, OBJ, PLY"});
  refused("a spacing without end", "box.stl", {"'Spacing' is '1e-05'", "box.stl", "4e+06"}, 1e-5);
  // Area 6 m²: 6/(0.43 · 1e-6) = 1.4e7 triangles.
  refused("a spacing for too many triangles", "box.stl", {"'Spacing' is '0.001'", "about 1.39", "e+07"},
          1e-3);
  write_stl("needle.stl", {{{Point<3>(0., 0., 0.), Point<3>(1., 0., 0.), Point<3>(1., 1e-12, 0.)}}});
  refused("or for too many along an edge", "needle.stl", {"'Spacing' is '1e-07'", "needle.stl"}, 1e-7);
  std::ofstream("header.off") << "OFF\n1000000000 1000000000 0\n";
  refused("a header of more than the file", "header.off",
          {"header.off", "1000000000 points and 1000000000 faces", "bytes long"});

  Triangles crossing = box_surface(1);
  for (const auto &triangle : box_surface(1))
  {
    crossing.push_back(triangle);
    for (Point<3> &p : crossing.back())
      p += Point<3>(0.5, 0.25, 0.3) - Point<3>();
  }
  write_stl("crossing.stl", crossing);
  refused("faces that cross", "crossing.stl",
          {"crossing.stl", "cross", "pairs", "; ", "boundaries with files of their own"});

  Triangles folded                    = box_surface(1);
  const std::array<Point<3>, 3> first = folded[0];
  folded.push_back(
    {{first[0], first[1], first[0] + 0.3 * (first[1] - first[0]) + 0.2 * (first[2] - first[0])}});
  write_stl("folded.stl", folded);
  refused("a third face of an edge that lies in another", "folded.stl", {"folded.stl", "cross"});

  const auto boundary = [](const Entries &entries) {
    return make_geometry<3>({boxes("5, 5, 5 : 6, 6, 6"), boundary_of("surface", entries)});
  };
  check_throws<InputError>("no file", {"'Boundaries/walls/surface/File'", "STL"}, [&]() { boundary({}); });
  check_throws<InputError>("a factor of zero", {"'Boundaries/walls/surface/Scale'"}, [&]() {
    boundary({{"File", "box.stl"}, {"Scale", "0"}});
  });
  const auto moved = boundary({{"File", "box.stl"}, {"Scale", "2"}, {"Origin", "1, 2, 3"}}).walls_at(0.);
  Point<3> lowest(9., 9., 9.);
  for (const auto &facet : moved.facets())
    for (const Point<3> &p : facet.corners)
      for (unsigned int d = 0; d < 3; ++d)
        lowest[d] = std::min(lowest[d], p[d]);
  check("the origin is subtracted after the factor", lowest.distance(Point<3>(-1., -2., -3.)), 1e-12);
  const auto warnings = boundary({{"File", "box.stl"}, {"Scale", "1e-3"}}).warnings(0.01);
  check("a drawing that is small for the mesh is said",
        warnings.size() == 1 && warnings[0].find("'Boundaries/walls/surface/Scale'") != std::string::npos);
}

int main()
{
  test_mending();
  test_joints();
  test_new_triangles();
  test_wrong_input();
  return n_failed;
}
