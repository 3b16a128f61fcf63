// SPDX-License-Identifier: GPL-3.0-or-later

// Test the mesh size as a function of the place: its values, its gradient, the spacing that particles get from it, and
// lines, polygons and bodies in space that are filled with it.

#include <lahar/geometry/delaunay.h>
#include <lahar/geometry/mesh_size.h>
#include <lahar/geometry/polygon.h>
#include <lahar/geometry/simplex_geometry.h>

#include "initial_case.h"

#include <algorithm>

using namespace Tests;

template <int dim>
MeshSize<dim> make(const std::string &boxes, const double mesh_size)
{
  Parameters prm;
  MeshSize<dim>::declare_parameters(prm);
  prm.enter_subsection("Remeshing");
  prm.set("Refined boxes", boxes);
  prm.leave_subsection();
  MeshSize<dim> result;
  result.parse_parameters(prm, mesh_size);
  return result;
}

void test_function()
{
  const MeshSize<2> h = make<2>("1, 1 : 3, 2 : 0.1; 3, 2 : 2, 0 : 0.05", 0.4);
  check("the size of the box", h({1., 1.5}) - 0.1, 1e-15);
  check("the smallest where boxes overlap", h({2.5, 1.5}) - 0.05, 1e-15);
  check("beside a box it grows by 0.2 of the distance", h({0.5, 1.5}) - 0.2, 1e-15);
  check("beside a corner, too", h({1. - 0.3, 2. + 0.4}) - 0.2, 1e-15);
  check("far away it is that of the case", h({10., 10.}) - 0.4, 1e-15);
  check("the smallest in a region", h.finest_in(Box<2>({0., 0.}, {0.5, 3.})) - 0.2, 1e-15);
  double steepest = 0.;
  Random random;
  for (unsigned int k = 0; k < 1000; ++k)
  {
    const Point<2> a(5. * random.vector<2>()), b = a + 0.1 * random.vector<2>();
    steepest = std::max(steepest, std::abs(h(a) - h(b)) / a.distance(b));
  }
  check("its gradient is at most 0.2, and somewhere it is", steepest < 0.2 + 1e-9 && steepest > 0.199);
  const std::vector<double> levels = h.levels();
  double largest_step              = 0.;
  for (unsigned int i = 1; i < levels.size(); ++i)
    largest_step = std::max(largest_step, levels[i] / levels[i - 1]);
  check("levels from the smallest size to the largest", levels.front() == 0.05 && levels.back() == 0.4);
  check("in steps of at most the square root of two", largest_step <= std::sqrt(2.) + 1e-12);
  check("one of them is the other box's", std::find(levels.begin(), levels.end(), 0.1) != levels.end());
  const MeshSize<3> uniform = make<3>("", 0.1);
  check("without boxes it is the same everywhere",
        uniform.is_uniform() && uniform({1., 2., 3.}) == 0.1 && uniform.levels().size() == 1);

  ParticleCloud<2> cloud;
  cloud.append({2.5, 1.5}, ParticleKind::fluid, 0.4);
  cloud.append({10., 1.5}, ParticleKind::fluid, 0.05);
  cloud.append({2.5, 1.5}, ParticleKind::wall, 0.4);
  h.update(cloud);
  check("the spacing of a particle falls by 15 % in a step", cloud.spacing[0] - 0.85 * 0.4, 1e-15);
  check("and grows at once", cloud.spacing[1] - 0.4, 1e-15);
  check("that of a wall stays", cloud.spacing[2] == 0.4);
  for (unsigned int step = 0; step < 13; ++step)
    h.update(cloud);
  check("until it is that of the place", cloud.spacing[0] - 0.05, 1e-15);
}

/// Lengths of the Delaunay edges within the cells that the alpha shape would take, over h in their middle.
template <int dim>
std::vector<double> edge_ratios(const std::vector<Point<dim>> &points, const MeshSize<dim> &h, double &volume)
{
  std::vector<double> ratios;
  volume = 0.;
  for (const Simplex<dim> &cell : delaunay<dim>(points))
  {
    const auto corners = corners_of<dim>(cell, points);
    if (circumradius<dim>(corners) > 1.25 * h(centroid<dim>(corners)))
      continue;
    volume += signed_volume<dim>(corners);
    for (unsigned int a = 0; a <= dim; ++a)
      for (unsigned int b = a + 1; b <= dim; ++b)
        ratios.push_back(corners[a].distance(corners[b]) / h(corners[a] + 0.5 * (corners[b] - corners[a])));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

void test_filling()
{
  const MeshSize<2> h = make<2>("0.3, 0 : 0.6, 0.2 : 0.01", 0.04);
  const auto line     = sample_polyline({{0., 0.}, {1.7, 0.}}, h, false);
  bool matching       = true;
  for (unsigned int i = 1; i < line.size(); ++i)
  {
    const double ratio = line[i].distance(line[i - 1]) / h(line[i - 1] + 0.5 * (line[i] - line[i - 1]));
    matching           = matching && ratio > 0.95 && ratio < 1.05;
  }
  check("a line is divided into pieces of length h", matching);
  // ∫ dx/h: 0.3 at 0.01; from there h grows to 0.04 on 0.15 on both sides; the rest of 1.1 at 0.04.
  check("their number is the integral of 1/h",
        line.size() - 1. - (0.3 / 0.01 + 2. * std::log(4.) / 0.2 + 1.1 / 0.04), 0.5);

  const Polygon square = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
  double area;
  const auto points  = fill_polygon(square, h, h.levels(), MPI_COMM_SELF).position;
  const auto in_area = edge_ratios<2>(points, h, area);
  check("a polygon is filled without holes", area - 1., 1e-10);
  check("no edge is below h/2 or above 1.6 h", in_area.front() > 0.5 && in_area.back() < 1.6);
  check("the median edge is h", in_area[in_area.size() / 2] - 1., 0.1);

  const MeshSize<3> h3              = make<3>("0.3, 0, 0 : 0.6, 0.5, 0.2 : 0.03", 0.09);
  const InitialGeometry<3> geometry = make_geometry<3>(
    {boxes("0, 0, 0 : 1, 0.5, 0.5"),
     fluid_of("cone",
              {{"Base", "0, 0, -2"}, {"Base radius", "0.5"}, {"Top radius", "0.3"}, {"Height", "0.5"}},
              "cone"),
     planes("-1, -1, 0 : 2, -1, 0 : 2, 2, 0 : -1, 2, 0")});
  ParticleCloud<3> cloud;
  Walls<3> walls;
  geometry.create(h3, SolidContour<3>({}, cloud), cloud, walls);
  std::vector<Point<3>> box, cone;
  bool spacing_is_h = true;
  for (unsigned int i = 0; i < cloud.size(); ++i)
  {
    spacing_is_h      = spacing_is_h && cloud.spacing[i] == h3(cloud.position[i]);
    const Point<3> &p = cloud.position[i];
    if (p[2] < -1.)
      cone.push_back(p);
    else if (p[0] > -1e-9 && p[0] < 1. + 1e-9 && p[1] > -1e-9 && p[1] < 0.5 + 1e-9)
      box.push_back(p);
  }
  double volume;
  const auto in_space = edge_ratios<3>(box, h3, volume);
  check("a box in space is filled", volume / 0.25 - 1., 0.01);
  check("few edges are below 0.6 h or above 1.5 h",
        in_space[in_space.size() / 100] > 0.6 && in_space[in_space.size() - in_space.size() / 100] < 1.5);
  check("the median edge in space is h", in_space[in_space.size() / 2] - 1., 0.1);
  check("every particle's spacing is h in its place", spacing_is_h);

  const MeshSize<3> in_cone = make<3>("-0.6, -0.6, -2 : 0.6, 0.6, -1.8 : 0.04", 0.1);
  ParticleCloud<3> second;
  geometry.create(in_cone, SolidContour<3>({}, second), second, walls);
  cone.clear();
  for (const Point<3> &p : second.position)
    if (p[2] < -1.)
      cone.push_back(p);
  const auto ratios = edge_ratios<3>(cone, in_cone, volume);
  check("a cone is filled", volume / (numbers::PI * 0.5 / 3. * (0.25 + 0.15 + 0.09)) - 1., 0.02);
  check("its median edge is h", ratios[ratios.size() / 2] - 1., 0.1);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_function();
  test_filling();
  for (const std::string wrong :
       {"0, 0 : 1, 1", "0, 0 : 1 : 0.1", "0, 0 : 0, 1 : 0.1", "0, 0 : 1, 1 : 0", "0, 0 : 1, 1 : -0.1",
        "0, 0 : 1, 1 : 0.5", "0, 0 : 1, 1 : x", "0, 0 : 1, 1 : nan"})
    check_throws<InputError>("refused: " + wrong,
                             {"Remeshing/Refined boxes", wrong, "x, y : x, y : mesh size",
                              "at most 'Mesh size', which is 0.4"},
                             [&]() { make<2>(wrong, 0.4); });
  return n_failed;
}
