// SPDX-License-Identifier: GPL-3.0-or-later

// Test ground from elevation grids: an analytic hill as ESRI ASCII grid, as GeoTIFF and as STL gives the same walls;
// resampling is bilinear and of second order; windows, origins, gaps and wrong files.

#include <cpl_string.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <lahar/geometry/point_set.h>

#include "hill.h"
#include "initial_case.h"

#include <algorithm>

using namespace Tests;

double hill(const double x, const double y)
{
  return 0.3 * std::exp(-4. * ((x - 1.) * (x - 1.) + (y - 0.8) * (y - 0.8))) + 0.1 * x;
}

/// @param srs of EPSG. Rows run from the north, or from the south if @p upwards.
void write_tif(const std::string &name, const Grid &grid, const int epsg, const bool upwards = false,
               const double turned = 0., const int n_bands = 1)
{
  GDALRegister_GTiff();
  const GDALDatasetH data = GDALCreate(GDALGetDriverByName("GTiff"), name.c_str(), grid.nx, grid.ny, n_bands,
                                       GDT_Float64, nullptr);
  const double s          = grid.spacing;
  std::array<double, 6> map = {
    {grid.x0 - 0.5 * s, s, turned, grid.y0 + (upwards ? -0.5 : grid.ny - 0.5) * s, 0., upwards ? s : -s}};
  GDALSetGeoTransform(data, map.data());
  if (epsg > 0)
  {
    const OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
    OSRImportFromEPSG(reference, epsg);
    GDALSetSpatialRef(data, reference);
    OSRDestroySpatialReference(reference);
  }
  std::vector<double> row(grid.nx);
  bool written = true;
  for (unsigned int j = 0; j < grid.ny; ++j)
  {
    for (unsigned int i = 0; i < grid.nx; ++i)
      row[i] = grid.at(i, j);
    written = written && GDALRasterIO(GDALGetRasterBand(data, 1), GF_Write, 0, upwards ? j : grid.ny - 1 - j,
                                      grid.nx, 1, row.data(), grid.nx, 1, GDT_Float64, 0, 0) == CE_None;
  }
  GDALClose(data);
  check("written: " + name, written);
}

/// The facets of a boundary with these entries.
std::vector<std::array<Point<3>, 3>> facets_of(const std::string &shape, const Entries &entries)
{
  std::vector<std::array<Point<3>, 3>> result;
  const auto geometry  = make_geometry<3>({boxes("5, 5, 5 : 6, 6, 6"), boundary_of(shape, entries)});
  const Walls<3> walls = geometry.walls_at(0.);
  for (const WallFacet<3> &facet : walls.facets())
    result.push_back(facet.corners);
  return result;
}

std::vector<std::array<Point<3>, 3>> terrain(const Entries &entries)
{
  return facets_of("terrain", entries);
}

/// The largest distance of corners that belong together; facets may come in any order.
double difference(std::vector<std::array<Point<3>, 3>> a, std::vector<std::array<Point<3>, 3>> b)
{
  if (a.size() != b.size() || a.empty())
    return 1e300;
  const auto less = [](const Point<3> &p, const Point<3> &q) {
    return std::make_pair(std::round(1e4 * p[0]), std::round(1e4 * p[1])) <
           std::make_pair(std::round(1e4 * q[0]), std::round(1e4 * q[1]));
  };
  for (auto *facets : {&a, &b})
  {
    for (auto &facet : *facets)
      std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end(), less), facet.end());
    std::sort(facets->begin(), facets->end(), [&](const auto &f, const auto &g) {
      return std::lexicographical_compare(f.begin(), f.end(), g.begin(), g.end(), less);
    });
  }
  double largest = 0.;
  for (unsigned int f = 0; f < a.size(); ++f)
    for (unsigned int v = 0; v < 3; ++v)
      largest = std::max(largest, a[f][v].distance(b[f][v]));
  return largest;
}

void test_formats()
{
  Grid grid;
  grid.z              = hill;
  const auto expected = grid.triangles();
  grid.write_asc("hill.asc");
  write_tif("hill.tif", grid, 32633);
  write_tif("hill_upwards.tif", grid, 0, true);
  write_stl("hill.stl", expected);
  write_indexed("hill.obj", expected);
  write_indexed("hill.ply", expected);
  check("an ESRI ASCII grid gives the hill's triangles",
        difference(terrain({{"File", "hill.asc"}}), expected), 1e-14);
  check("a GeoTIFF the same", difference(terrain({{"File", "hill.tif"}}), expected), 1e-14);
  check("a GeoTIFF whose rows run upwards, too",
        difference(terrain({{"File", "hill_upwards.tif"}}), expected), 1e-14);
  for (const std::string file : {"hill.stl", "hill.obj", "hill.ply"})
    check(file + " gives the same walls", difference(facets_of("surface", {{"File", file}}), expected),
          1e-14);
  const auto moved = terrain({{"File", "hill.asc"}, {"Origin", "0.3, -0.2, 1"}});
  check("an origin moves it", moved[7][1].distance(expected[7][1] - Tensor<1, 3>({0.3, -0.2, 1.})), 1e-14);

  Grid far = grid;
  far.x0   = 431000.5;
  far.y0   = 5212000.25;
  far.z    = [&](const double x, const double y) { return 1800. + hill(x - far.x0, y - far.y0); };
  far.write_asc("far.asc");
  write_tif("far.tif", far, 32633);
  for (const std::string file : {"far.asc", "far.tif"})
    check(file + ": coordinates of a map, origin subtracted",
          difference(terrain({{"File", file}, {"Origin", "431000.5, 5212000.25, 1800"}}), expected), 1e-8);

  const auto part = terrain({{"File", "hill.asc"}, {"Window", "0.5, 1.2, 0.3, 1.1"}});
  check("a window along the file's lines", part.size() == 2 * 7 * 8);
  bool known = true;
  for (const auto &facet : part)
    known = known && std::any_of(expected.begin(), expected.end(), [&](const auto &other) {
              return std::equal(facet.begin(), facet.end(), other.begin(),
                                [](const Point<3> &p, const Point<3> &q) { return p.distance(q) < 1e-13; });
            });
  check("has the file's triangles", known);
  const auto between = terrain({{"File", "hill.asc"}, {"Window", "0.53, 1.19, 0.3, 1.1"}});
  double lowest = 9., highest = 0.;
  for (const auto &facet : between)
    for (const Point<3> &p : facet)
    {
      lowest  = std::min(lowest, p[0]);
      highest = std::max(highest, p[0]);
    }
  check("one between them ends where it should", std::abs(lowest - 0.53) + std::abs(highest - 1.19), 1e-14);
}

void test_resampling()
{
  Grid bilinear;
  bilinear.z = [](const double x, const double y) { return 0.3 + 0.2 * x - 0.1 * y + 0.4 * x * y; };
  bilinear.write_asc("bilinear.asc");
  double largest = 0.;
  for (const std::string spacing : {"0.033", "0.1", "0.27", "1"})
    for (const auto &facet : terrain({{"File", "bilinear.asc"}, {"Spacing", spacing}}))
      for (const Point<3> &p : facet)
        largest = std::max(largest, std::abs(p[2] - bilinear.z(p[0], p[1])));
  check("a bilinear surface stays itself at any spacing", largest, 1e-14);
  check("a spacing divides the window",
        terrain({{"File", "bilinear.asc"}, {"Spacing", "0.27"}}).size() == 2 * 7 * 6);

  std::vector<double> errors;
  for (const double spacing : {0.1, 0.05, 0.025})
  {
    Grid grid;
    grid.spacing = spacing;
    grid.nx      = std::lround(2. / spacing) + 1;
    grid.ny      = std::lround(1.6 / spacing) + 1;
    grid.z       = hill;
    grid.write_asc("hill_at_spacing.asc");
    double worst = 0.;
    for (const auto &facet : terrain({{"File", "hill_at_spacing.asc"}, {"Spacing", "0.02"}}))
      for (const Point<3> &p : facet)
        worst = std::max(worst, std::abs(p[2] - hill(p[0], p[1])));
    errors.push_back(worst);
  }
  check("elevations between points are of second order",
        std::log2(errors[0] / errors[1]) > 1.8 && std::log2(errors[1] / errors[2]) > 1.8);
}

void test_particles()
{
  // A wall of the law 'wall particles' carries particles at the mesh size, finer and coarser than the grid.
  Grid grid;
  grid.z = hill;
  grid.write_asc("hill.asc");
  for (const double h : {0.06, 0.1, 0.2})
  {
    ParticleCloud<3> cloud;
    Walls<3> walls;
    make_geometry<3>({boxes("5, 5, 5 : 6, 6, 6"), boundary_of("terrain", {{"File", "hill.asc"}})})
      .create(h, SolidContour<3>({}, cloud), cloud, walls);
    double off = 0.;
    PointSet<3> places;
    bool apart = true, covered = true;
    for (unsigned int i = 0; i < cloud.size(); ++i)
      if (const Point<3> &p = cloud.position[i]; cloud.kind[i] == ParticleKind::wall)
      {
        off   = std::max(off, std::abs(p[2] - hill(p[0], p[1])));
        apart = places.insert_if_free(p, 0.59 * h) && apart;
      }
    for (const WallFacet<3> &facet : walls.facets())
      covered = covered &&
                !places.near(facet.corners[0] + (facet.corners[1] - facet.corners[0]) / 3., h).empty();
    check("particles of the ground at " + std::to_string(h) + " m lie on it", off, 0.01);
    check("0.6 h apart, and nowhere farther than h", apart && covered);
  }
}

void test_wrong_input()
{
  const auto refused = [](const std::string &what, const Entries &entries,
                          const std::vector<std::string> &words) {
    check_throws<InputError>(what, words, [&]() { terrain(entries); });
  };
  const std::string path = "'Boundaries/walls/terrain/";
  refused("no file", {}, {path + "File'", "GeoTIFF"});
  refused("a missing file", {{"File", "nowhere.asc"}}, {"nowhere.asc", "does not exist", "GeoTIFF"});
  std::ofstream("text.asc") << "no grid at all\n";
  refused("no grid", {{"File", "text.asc"}}, {"text.asc", "cannot be read", "Allowed"});
  std::ofstream("short.asc") << "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5\n";
  refused("a grid that is cut off", {{"File", "short.asc"}}, {"short.asc", "Allowed"});
  for (const std::string window : {"0, 1", "1, 0, 0, 1", "0, 1, 1, 1", "0, 1, 0, x", "0, nan, 0, 1"})
    refused("window " + window, {{"File", "hill.asc"}, {"Window", window}},
            {path + "Window'", window, "x0 < x1"});
  refused("a window beside the grid", {{"File", "hill.asc"}, {"Window", "1, 2.5, 0, 1"}},
          {"hill.asc", "from 0 to 2 m in x", "from 1 to 2.5", "Allowed"});
  refused("a spacing without end", {{"File", "hill.asc"}, {"Spacing", "1e-6"}},
          {path + "Spacing'", "1e-6", "'Window'", "4e+06"});

  Grid grid;
  grid.z = [](const double x, const double y) {
    return std::abs(x - 1.) < 0.15 && y > 1. ? std::numeric_limits<double>::quiet_NaN() : hill(x, y);
  };
  grid.write_asc("gaps.asc");
  refused("gaps in the window", {{"File", "gaps.asc"}},
          {"gaps.asc", "no elevation at 18 of 357", "(0.9 1.1)", "Window"});
  check("none in the window", terrain({{"File", "gaps.asc"}, {"Window", "0, 2, 0, 1"}}).size() == 400);
  grid.z = hill;
  write_tif("degrees.tif", grid, 4326);
  refused("coordinates in degrees", {{"File", "degrees.tif"}}, {"degrees.tif", "degrees", "UTM"});
  write_tif("feet.tif", grid, 2225);
  refused("coordinates in feet", {{"File", "feet.tif"}}, {"feet.tif", "0.3048", "Allowed: coordinates in m"});
  write_tif("turned.tif", grid, 0, false, 0.01);
  refused("a turned grid", {{"File", "turned.tif"}}, {"turned.tif", "west to east"});
  write_tif("bands.tif", grid, 0, false, 0., 3);
  refused("three bands", {{"File", "bands.tif"}}, {"bands.tif", "3 bands", "Allowed: one"});

  const auto warnings = [](const std::string &file, const double h) {
    return make_geometry<3>({boxes("5, 5, 5 : 6, 6, 6"), boundary_of("terrain", {{"File", file}})})
      .warnings(h);
  };
  check("no warning where the map is known and the sizes agree", warnings("hill.tif", 0.1).empty());
  const auto has = [](const std::vector<std::string> &texts, const std::vector<std::string> &words) {
    return texts.size() == 1 && std::all_of(words.begin(), words.end(), [&](const std::string &word) {
             return texts[0].find(word) != std::string::npos;
           });
  };
  check("a grid without projection", has(warnings("hill.asc", 0.1), {"hill.asc", "projection"}));
  check("a fine grid",
        has(warnings("hill.tif", 1.), {"'walls'", "0.1 m apart", "'Mesh size' is 1 m", "Spacing'"}));
  check("a coarse grid", has(warnings("hill.tif", 1e-4), {"0.1 m apart", "0.0001 m"}));
  check_throws<InputError>("a grid of 1e-5 mesh sizes", {"0.1 m apart", "10000 m", "Spacing'"},
                           [&]() { warnings("hill.tif", 1e4); });
  check_throws<InputError>("a grid of 1e5 mesh sizes", {"0.1 m apart", "1e-06 m", "Spacing'"},
                           [&]() { warnings("hill.tif", 1e-6); });
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_formats();
  test_resampling();
  test_particles();
  test_wrong_input();
  return n_failed;
}
