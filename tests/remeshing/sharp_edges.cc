// SPDX-License-Identifier: GPL-3.0-or-later

// Test which cells stay fluid at walls in space: those that reach round a sharp edge of a body do not; those over its
// edge, over the ridges of uneven ground and over a rounded crest do.

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/remeshing/alpha_shape.h>

#include "tests.h"

using namespace Tests;

/// The mesh size, m.
constexpr double h = 0.01;

/// Strips upright on, or along y over, the line through points of the plane (x, y) or (x, z), in mesh sizes.
Walls<3> walls_along(const std::vector<Point<2>> &line, const bool upright)
{
  std::vector<WallFacet<3>> facets;
  for (unsigned int k = 0; k + 1 < line.size(); ++k)
  {
    const auto at = [&](const Point<2> &p, const double along) {
      return h * (upright ? Point<3>(p[0], p[1], along) : Point<3>(p[0], along, p[1]));
    };
    const Point<3> a = at(line[k], -3.), b = at(line[k + 1], -3.), c = at(line[k + 1], 3.),
                   d = at(line[k], 3.);
    facets.push_back({{{a, b, c}}, true});
    facets.push_back({{{a, c, d}}, true});
  }
  return Walls<3>(facets);
}

/// Whether a cell that was fluid stays it. Corners are in mesh sizes; the first ones are fluid in contact, moved off by
/// contact_offset along @p outwards, the others what @p rest says.
bool stays(const std::vector<std::pair<Point<3>, Tensor<1, 3>>> &landed,
           const std::vector<std::pair<Point<3>, ParticleKind>> &rest, const Walls<3> &walls)
{
  ParticleCloud<3> cloud;
  for (const auto &[place, outwards] : landed)
  {
    const unsigned int i       = cloud.append(h * (place + contact_offset / outwards.norm() * outwards),
                                              ParticleKind::fluid, h);
    cloud.contact_facets[i][0] = 0;
  }
  for (const auto &[place, kind] : rest)
    cloud.append(h * place, kind, h);
  Simplex<3> cell = {{0, 1, 2, 3}};
  if (signed_volume<3>(corners_of<3>(cell, cloud.position)) < 0.)
    std::swap(cell[2], cell[3]);
  cell = canonical<3>(cell);
  FluidMesh<3> mesh;
  mesh.reinit(cloud, {cell});
  AlphaShape<3> rule;
  parse(rule);
  return rule.judge(cell, cloud, walls, OldDomain<3>(cloud, mesh), 1e-3) ==
         AlphaShape<3>::Verdict::stays_fluid;
}

/// A body in x > 0, y > 0 whose upright edge carries particles.
void test_body()
{
  const Walls<3> walls = walls_along({{6., 0.}, {0., 0.}, {0., 6.}}, true);
  const Tensor<1, 3> front({0., -1., 0.}), side({-1., 0., 0.});
  const auto fluid = ParticleKind::fluid, wall = ParticleKind::wall;
  const Point<3> on_front(0.2352, 0., 1.6694), on_side(0., 0.1623, 1.3714), off(-0.1162, -0.741, 2.0704);
  check("no cell from face to face above the edge's particle, 0.12 h behind them",
        !stays({{on_front, front}, {Point<3>(0., 0.7212, 1.2327), side}},
               {{Point<3>(0., 0., 1.), wall}, {Point<3>(-0.424, -0.1084, 1.2599), fluid}}, walls));
  check("nor below it, 0.08 h behind them",
        !stays({{on_front, front}, {on_side, side}}, {{Point<3>(0., 0., 2.), wall}, {off, fluid}}, walls));
  check("nor from a particle close to the edge to one before the other face",
        !stays({{Point<3>(0., 0.0805, 0.5), side}},
               {{Point<3>(1.9677, -0.8105, 0.5), fluid},
                {Point<3>(0.1174, -0.6935, 0.), fluid},
                {Point<3>(-0.6638, -0.3824, 1.), fluid}},
               walls));
  check("a cell from face to face round two particles of the edge is none",
        !stays({{on_front, front}, {on_side, side}},
               {{Point<3>(0., 0., 1.), wall}, {Point<3>(0., 0., 2.), wall}}, walls));
  check("cells on each face, with the edge's particles, stay",
        stays({{on_front, front}}, {{Point<3>(0., 0., 1.), wall}, {Point<3>(0., 0., 2.), wall}, {off, fluid}},
              walls) &&
          stays({{on_side, side}}, {{Point<3>(0., 0., 1.), wall}, {Point<3>(0., 0., 2.), wall}, {off, fluid}},
                walls));
  check("what is in contact with both faces at the edge belongs to each",
        stays({{on_front, front}, {Point<3>(0., 0., 1.2), front + side}},
              {{Point<3>(0., 0., 2.), wall}, {off, fluid}}, walls));
  check("in the corner of the other side cells between particles that lie on the faces stay",
        stays({},
              {{Point<3>(0.5, 0., 1.), wall},
               {Point<3>(0., 0.5, 1.3), wall},
               {Point<3>(0., 0., 1.), wall},
               {Point<3>(0.5, 0.5, 1.6), fluid}},
              walls) &&
          stays({},
                {{Point<3>(0.5, 0., 1.), wall},
                 {Point<3>(0., 0.5, 1.3), wall},
                 {Point<3>(0.9, 0.8, 0.9), fluid},
                 {Point<3>(0.5, 0.5, 1.9), fluid}},
                walls));
}

/// The edge of a wedge of 30 degrees towards −x: its faces' normals point away from each other.
void test_wedge()
{
  const double t       = std::tan(numbers::PI / 12.);
  const Walls<3> walls = walls_along({{6., 6. * t}, {0., 0.}, {6., -6. * t}}, true);
  const Tensor<1, 3> left({-t, 1., 0.}), right({-t, -1., 0.});
  check("no cell through the edge of a wedge",
        !stays({{Point<3>(0.3, 0.3 * t, 0.), left}, {Point<3>(0.3, -0.3 * t, 0.5), right}},
               {{Point<3>(0., 0., 1.), ParticleKind::wall}, {Point<3>(-0.8, 0., 0.5), ParticleKind::fluid}},
               walls));
}

void test_ground()
{
  const auto over = [](const std::vector<Point<2>> &profile, const Point<2> &left, const Point<2> &right) {
    const auto outwards = [](const double x, const double slope) {
      return Tensor<1, 3>({x < 0. ? -slope : slope, 0., 1.});
    };
    const double slope = (profile[1][1] - profile[0][1]) / (profile[1][0] - profile[0][0]);
    return stays({{Point<3>(left[0], 0., left[1]), outwards(-1., slope)},
                  {Point<3>(right[0], 0.5, right[1]), outwards(1., slope)}},
                 {{Point<3>(0.1, 0.2, 1.), ParticleKind::fluid},
                  {Point<3>(0.2, -0.6, 0.8), ParticleKind::fluid}},
                 walls_along(profile, false));
  };
  for (const double slope : {0.1, 0.2, 0.4})
    check("a cell over a ridge stays, slopes of " + std::to_string(slope).substr(0, 3),
          over({{-3., -3. * slope}, {0., 0.}, {3., -3. * slope}}, {-0.6, -0.6 * slope}, {0.6, -0.6 * slope}));
  check("over two ridges and the valley between",
        over({{-3., -0.48}, {-0.6, 0.}, {0., -0.12}, {0.6, 0.}, {3., -0.48}}, {-1.1, -0.1}, {1.1, -0.1}));
  check("from the top of a ridge to below the next one",
        over({{-3., -0.12}, {-0.6, 0.}, {-0.2, -0.02}, {0.2, 0.03}, {3., -0.32}}, {-0.6, 0.}, {0.6, -0.02}));
  const double t = std::tan(numbers::PI / 6.);
  check("over a crest that turns by 60 degrees in two joints of 30",
        over({{-3., -2.6 * t}, {-0.4, 0.}, {0.4, 0.}, {3., -2.6 * t}}, {-0.6, -0.2 * t}, {0.6, -0.2 * t}));
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_body();
  test_wedge();
  test_ground();
  return n_failed > 0;
}
