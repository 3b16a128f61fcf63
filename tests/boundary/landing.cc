// SPDX-License-Identifier: GPL-3.0-or-later

// Test how fluid lands on walls: it sticks where the law says so, keeps to its side of walls without thickness and of
// thin bodies, goes on along smooth surfaces and stays in sharp hollow corners; and which edges of walls are sharp.

#include <lahar/boundary/wall_contact.h>
#include <lahar/geometry/sharp_edges.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

WallFacet<2> line(const Point<2> &a, const Point<2> &b, const bool sticks, const unsigned int boundary = 0)
{
  return {{{a, b}}, true, boundary, false, sticks};
}

void test_sticking()
{
  const Walls<2> walls({line({0., 0.}, {2., 0.}, true), line({2., 0.}, {4., 0.}, false)});
  const WallStep<2> standing(walls);
  const WallContact<2> contact(standing);
  ParticleCloud<2> cloud;
  const double h                           = 0.1;
  const std::vector<Point<2>> old_position = {{1., 0.02}, {3., 0.02}};
  for (const Point<2> &p : old_position)
  {
    const unsigned int i = cloud.append(p, ParticleKind::fluid, h);
    cloud.position[i] += Point<2>(0.01, -0.03);
    cloud.velocity[i]     = Point<2>(1., -3.);
    cloud.acceleration[i] = Point<2>(5., -9.);
  }
  contact.update(old_position, cloud);
  check("sticks: at rest where it lands", cloud.velocity[0].norm() + cloud.acceleration[0].norm() == 0. &&
                                            contact.constraint(0, cloud).n_fixed == 2);
  check("sticks: on its side", (cloud.position[0] - Point<2>(1.01, contact_offset * h)).norm(), 1e-15);
  check("slides: only its normal velocity is fixed",
        (cloud.velocity[1] - Point<2>(1., 0.)).norm() < 1e-15 && contact.constraint(1, cloud).n_fixed == 1);
}

void test_sides()
{
  // A wall without thickness, and a plate of 0.04 h.
  const Walls<2> walls({line({0., 0.}, {0., 1.}, false), line({1., 0.}, {1., 1.}, false),
                        line({1.004, 1.}, {1.004, 0.}, false)});
  const WallStep<2> standing(walls);
  const WallContact<2> contact(standing);
  ParticleCloud<2> cloud;
  const double h                           = 0.1;
  const std::vector<Point<2>> old_position = {{-0.02, 0.5}, {0.02, 0.5}, {-0.03, 0.6},
                                              {0.98, 0.5},  {1.02, 0.5}, {0.97, 0.6}};
  const std::vector<double> moved_to       = {-0.001, 0.001, 0.01, 0.998, 1.006, 1.02};
  const std::vector<double> expected       = {0., 0., 0., 1., 1.004, 1.};
  const std::vector<int> sides             = {-1, 1, -1, -1, 1, -1};
  for (unsigned int i = 0; i < old_position.size(); ++i)
  {
    cloud.append(old_position[i], ParticleKind::fluid, h);
    cloud.position[i][0] = moved_to[i];
  }
  contact.update(old_position, cloud);
  double error = 0.;
  for (unsigned int i = 0; i < old_position.size(); ++i)
    error = std::max(error, std::abs(cloud.position[i][0] - expected[i] - sides[i] * contact_offset * h));
  check("each particle on its side of the wall and of the plate", error, 1e-15);
  check("what is on either side passes through it",
        walls.crossed(cloud.position[0], cloud.position[1], 0., 0.).size() == 1 &&
          walls.crossed(cloud.position[0], cloud.position[2], 0., 0.).empty());
  check("a facet hides the one behind it",
        walls.is_hidden(2, {0.99, 0.5}) && !walls.is_hidden(1, {0.99, 0.5}));
}

void test_joints()
{
  // A hollow of pieces at 20 degrees to each other, then a corner of 90 degrees.
  const double s = std::sin(numbers::PI / 9.), c = std::cos(numbers::PI / 9.);
  const Point<2> joint(1., 0.), end(1. + c, s);
  const Walls<2> walls(
    {line({0., 0.}, joint, false), line(joint, end, false), line(end, end + Point<2>(-s, c), false)});
  const WallStep<2> standing(walls);
  const WallContact<2> contact(standing);
  ParticleCloud<2> cloud;
  const double h             = 0.1;
  const unsigned int i       = cloud.append({0.99, contact_offset * h}, ParticleKind::fluid, h);
  cloud.contact_facets[i][0] = 0;
  std::vector<Point<2>> old_position;
  const auto move_to = [&](const Point<2> &p) {
    old_position      = cloud.position;
    cloud.position[i] = p;
    contact.update(old_position, cloud);
  };
  const auto facets = [&] { return cloud.contact_facets[i]; };
  const int none    = ParticleCloud<2>::no_facet;
  move_to({0.995, contact_offset * h});
  check("near the next piece it stays on the first", facets() == std::array<int, 2>{{0, none}});
  move_to({1.01, contact_offset * h});
  check("beyond the joint it goes on along the next", facets() == std::array<int, 2>{{1, none}});
  check("on its side of it",
        walls.signed_distance(1, cloud.position[i]) * (walls.normal(1)[1] > 0. ? 1. : -1.) -
          contact_offset * h,
        1e-15);
  check("sliding freely", contact.constraint(i, cloud).n_fixed == 1);
  move_to(Point<2>(end - 0.005 * Point<2>(c, s) + contact_offset * h * Point<2>(-s, c)));
  check("at a sharp corner it belongs to both",
        facets() == std::array<int, 2>{{2, 1}} || facets() == std::array<int, 2>{{1, 2}});
  check("and stands", contact.constraint(i, cloud).n_fixed == 2);
}

/// A bulge of pieces at 20 degrees to each other, which it passes in small and in large steps; and the edge of a wedge.
void test_bulge()
{
  const double s = std::sin(numbers::PI / 9.), c = std::cos(numbers::PI / 9.), h = 0.1;
  const Point<2> joint(1., 0.), end(1. + c, -s);
  const int none = ParticleCloud<2>::no_facet;
  for (const bool turned : {false, true}) // the normal of the second piece
  {
    const Walls<2> walls(
      {line({0., 0.}, joint, false), turned ? line(end, joint, false) : line(joint, end, false)});
    const WallStep<2> standing(walls);
    const WallContact<2> contact(standing);
    const auto height = [&](const unsigned int facet, const Point<2> &p) {
      return std::copysign(1., walls.signed_distance(facet, {1., 1.})) * walls.signed_distance(facet, p);
    };
    for (const double length : {1e-5, 3e-4, 0.01})
    {
      ParticleCloud<2> cloud;
      cloud.append({0.98, contact_offset * h}, ParticleKind::fluid, h);
      cloud.contact_facets[0][0] = 0;
      bool on_one = true, keeps_side = true;
      for (double x = 1. - 2.5 * length; x < 1. + 3. * length; x += length)
      {
        const auto old_position = cloud.position;
        // As the constraint of its facet has it.
        cloud.position[0] = cloud.contact_facets[0][0] == 0
                              ? Point<2>(x, contact_offset * h)
                              : joint + (x - 1.) * Point<2>(c, -s) + contact_offset * h * Point<2>(s, c);
        contact.update(old_position, cloud);
        on_one     = on_one && cloud.contact_facets[0][0] != none && cloud.contact_facets[0][1] == none;
        keeps_side = keeps_side &&
                     std::abs(height(cloud.contact_facets[0][0] == 1 ? 1 : 0, cloud.position[0]) -
                              contact_offset * h) < 1e-15;
      }
      check("over a bulge it belongs to one piece at a time", on_one);
      check("on its outer side", keeps_side);
      check("and goes on along the next", cloud.contact_facets[0][0] == 1);
    }
  }
  for (const double rise : {0., 0.3}) // a plane of two pieces, and a hollow
  {
    // Something pushes it below its piece, before and beyond the joint: it comes back on top, whatever rounding says of the
    // planes, in any direction.
    bool on_top = true;
    for (double angle = 0.; angle < 6.; angle += 0.1)
      for (const Point<2> &pushed_to :
           {Point<2>(0.7, -0.02), Point<2>(0.995, -0.005), Point<2>(1.02, -0.005)})
      {
        const auto turned = [angle](const Point<2> &p) {
          return Point<2>(std::cos(angle) * p[0] - std::sin(angle) * p[1],
                          std::sin(angle) * p[0] + std::cos(angle) * p[1]);
        };
        const Walls<2> walls(
          {line(turned({0., 0.}), turned(joint), false), line(turned(joint), turned({2., rise}), false)});
        const WallStep<2> standing(walls);
        const WallContact<2> contact(standing);
        ParticleCloud<2> cloud;
        cloud.append(turned({0.99, contact_offset * h}), ParticleKind::fluid, h);
        cloud.contact_facets[0][0] = 0;
        const auto old_position    = cloud.position;
        cloud.position[0]          = turned(pushed_to);
        contact.update(old_position, cloud);
        const Point<2> &p = cloud.position[0];
        const double x    = std::cos(angle) * p[0] + std::sin(angle) * p[1],
                     y    = std::cos(angle) * p[1] - std::sin(angle) * p[0];
        on_top            = on_top && y > rise * std::max(x - 1., 0.) && cloud.in_contact(0);
      }
    check("pushed through its piece it comes back on top", on_top);
  }
  {
    // A wedge whose back the particle does not see.
    const Walls<2> walls({line({0., 0.}, joint, false), line(joint, {0., -0.01}, false)});
    const WallStep<2> standing(walls);
    const WallContact<2> contact(standing);
    ParticleCloud<2> cloud;
    cloud.append({0.98, contact_offset * h}, ParticleKind::fluid, h);
    cloud.contact_facets[0][0] = 0;
    const auto old_position    = cloud.position;
    cloud.position[0]          = {0.99999, contact_offset * h};
    contact.update(old_position, cloud);
    check("at the edge of a wedge it stays on its face",
          cloud.contact_facets[0] == std::array<int, 2>{{0, none}});
  }
}

/// The ground around a point of terrain, of 2 × 2 rectangles of 10 m of two triangles each; heights from the upper left on.
Walls<3> ground(const std::array<double, 9> &heights)
{
  std::vector<WallFacet<3>> facets;
  const auto corner = [&](const unsigned int i, const unsigned int j) {
    return Point<3>(10. * i, 10. * j, heights[3 * (2 - j) + i]);
  };
  for (unsigned int j = 0; j < 2; ++j)
    for (unsigned int i = 0; i < 2; ++i)
    {
      facets.push_back({{{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)}}, true, 0, false, false});
      facets.push_back({{{corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)}}, true, 0, false, false});
    }
  return Walls<3>(facets);
}

/// Uneven ground whose facets meet at some degrees, hollow and bulging: particles pass the joints and the corner in the
/// middle in all directions, in contact, or landing there.
void test_ground()
{
  const double h = 5.;
  bool on_top = true, in_contact = true, free_along = true;
  for (const auto &heights : {std::array<double, 9>{{157., 158., 159., 160., 161., 163., 163., 164., 166.}},
                              std::array<double, 9>{{126., 129., 131., 128., 130., 132., 128., 130., 132.}},
                              std::array<double, 9>{{137., 140., 142., 136., 139., 141., 136., 138., 141.}},
                              std::array<double, 9>{{110., 110., 118., 110., 110., 117., 110., 110., 115.}}})
  {
    const Walls<3> walls = ground(heights);
    const WallStep<3> standing(walls);
    const WallContact<3> contact(standing);
    for (const auto &[start, flies] :
         {std::make_pair(0., false), std::make_pair(0.03, false), std::make_pair(0.3, false),
          std::make_pair(0., true)}) // above the ground, over h
      for (double angle = 0.05; angle < 6.3; angle += 0.15)
        for (double offset = -0.3; offset < 0.31; offset += 0.06)
        {
          const Tensor<1, 3> along = Point<3>(std::cos(angle), std::sin(angle), 0.),
                             aside = Point<3>(-along[1], along[0], 0.);
          // The height of the ground, and its facet there.
          const auto facet_at = [&](const Point<3> &p) {
            for (unsigned int f = 0; f < walls.facets().size(); ++f)
            {
              Point<3> foot = p;
              foot[2] -= walls.signed_distance(f, p) / walls.normal(f)[2];
              if (walls.is_above(f, foot, 0.))
                return f;
            }
            return numbers::invalid_unsigned_int;
          };
          const auto height = [&](const Point<3> &p) {
            const unsigned int f = facet_at(p);
            return walls.signed_distance(f, p) / walls.normal(f)[2];
          };
          Point<3> place = Point<3>(10., 10., 0.) - 0.5 * along + offset * aside;
          place[2] -= height(place);
          const unsigned int first = facet_at(place);
          ParticleCloud<3> cloud;
          cloud.append(place + (start * h + contact_offset * h) * walls.normal(first), ParticleKind::fluid,
                       h);
          if (start == 0.)
            cloud.contact_facets[0][0] = first;
          for (unsigned int n = 0; n < 4; ++n)
          {
            const std::vector<Point<3>> old_position = cloud.position;
            Tensor<1, 3> way                         = 0.3 * along;
            if (flies)
              way[2] -= 0.05 * h;
            else if (cloud.in_contact(0))
            {
              const NodeConstraint<3> fixed = contact.constraint(0, cloud);
              for (unsigned int a = 0; a < fixed.n_fixed; ++a)
                way -= (fixed.frame[a] * way) * fixed.frame[a];
            }
            else
              way[2] -= 0.15 * h;
            cloud.position[0] += way;
            contact.update(old_position, cloud, {flies});
            for (const int facet : cloud.contact_facets[0])
              on_top = on_top && (facet == ParticleCloud<3>::no_facet ||
                                  walls.signed_distance(facet, cloud.position[0]) > 0.);
          }
          on_top     = on_top && height(cloud.position[0]) > -1e-3 * h;
          in_contact = in_contact && cloud.in_contact(0);
          free_along = free_along && contact.constraint(0, cloud).n_fixed == 1;
        }
  }
  check("on uneven ground particles are on top of all facets that they touch", on_top);
  check("and stay in contact", in_contact);
  check("with one facet at a time", free_along);
}

/// The upper edge of a step: what flows over it is not held.
void test_edge()
{
  const double h = 0.1;
  const int none = ParticleCloud<2>::no_facet;
  const Walls<2> walls({line({0., 0.}, {1., 0.}, false), line({1., 0.}, {1., -1.}, false)});
  const WallStep<2> standing(walls);
  const WallContact<2> contact(standing);
  ParticleCloud<2> cloud;
  cloud.append({0.97, contact_offset * h}, ParticleKind::fluid, h);
  cloud.contact_facets[0][0] = 0;
  for (const double x : {0.993, 0.9999, 1.004})
  {
    const auto old_position = cloud.position;
    cloud.position[0][0]    = x;
    contact.update(old_position, cloud);
    if (x < 1.)
      check("close to the edge of a step it slides on",
            cloud.contact_facets[0] == std::array<int, 2>{{0, none}});
  }
  check("beyond it is free to fall",
        contact.constraint(0, cloud).n_fixed < 2 && std::abs(cloud.position[0][0] - 1.004) < 0.0041);
}

/// A wall along (3, 4) that moves along itself, and a floor on which a wall comes along, in a step of 0.1 s.
void test_moving()
{
  const auto move = [](const Point<2> &by) {
    RigidMotion<2> motion;
    motion.shift = by;
    return motion;
  };
  const auto moved = [](std::vector<WallFacet<2>> facets, const std::vector<Point<2>> &by) {
    for (unsigned int f = 0; f < facets.size(); ++f)
      for (Point<2> &corner : facets[f].corners)
        corner += by[f];
    return Walls<2>(facets);
  };
  const double h = 0.1;
  {
    const std::vector<WallFacet<2>> facets = {line({0., 0.}, {3., 4.}, true, 0),
                                              line({0., 9.}, {1., 9.}, false, 1)};
    const Walls<2> start(facets), end = moved(facets, {{0.03, 0.04}, {0., 0.}});
    const WallStep<2> step(start, end, {move({0.03, 0.04}), {}}, 0.1);
    ParticleCloud<2> cloud;
    cloud.append({1.5 + 4e-10, 2. - 3e-10}, ParticleKind::fluid, h);
    cloud.contact_facets[0][0] = 0;
    const auto constraint      = WallContact<2>(step).constraint(0, cloud);
    check("sticks to a wall that moves along itself",
          constraint.n_fixed == 2 && constraint.moves &&
            (constraint.velocity - Point<2>(0.3, 0.4)).norm() < 1e-12);
  }
  for (const bool wall_sticks : {false, true})
  {
    const std::vector<WallFacet<2>> facets = {line({-1., 0.}, {2., 0.}, true, 0),
                                              line({0., 0.}, {0., 1.}, wall_sticks, 1)};
    const Walls<2> start(facets), end = moved(facets, {{0., 0.}, {0.02, 0.}});
    const WallStep<2> step(start, end, {{}, move({0.02, 0.})}, 0.1);
    ParticleCloud<2> cloud;
    const Point<2> corner(contact_offset * h, contact_offset * h);
    cloud.append(corner, ParticleKind::fluid, h);
    cloud.contact_facets[0] = {{1, 0}};
    const auto constraint   = WallContact<2>(step).constraint(0, cloud);
    check("pushed along the floor that it sticks to",
          constraint.n_fixed == 2 && (constraint.velocity - Point<2>(0.2, 0.)).norm() < 1e-6);
  }
}

template <int dim>
unsigned int number_at(const std::vector<std::pair<Point<dim>, unsigned int>> &points,
                       const Point<dim> &place)
{
  return std::count_if(points.begin(), points.end(),
                       [&](const auto &point) { return point.first.distance(place) < 1e-12; });
}

void test_sharp_edges()
{
  // A floor with an upright wall in its middle, a bend of 20 degrees and an upright end; another wall slips.
  const double s = std::sin(numbers::PI / 9.), c = std::cos(numbers::PI / 9.);
  const Point<2> bend(1., 0.), end(1. + c, s);
  const Walls<2> walls({line({-1., 0.}, bend, true), line(bend, end, true),
                        line(end, end + Point<2>(0., 1.), true), line({0., 0.}, {0., 1.}, true, 1),
                        line({5., 0.}, {5., 1.}, false)});
  const auto points = points_on_sharp_edges(walls, MeshSize<2>(0.1));
  check("free ends", number_at<2>(points, {-1., 0.}) == 1 && number_at<2>(points, {0., 1.}) == 1);
  check("a sharp corner", number_at<2>(points, end) == 1);
  const auto knife =
    points_on_sharp_edges(Walls<2>({line({0., 0.}, {1., 0.1}, true), line({1., 0.1}, {0., 0.2}, true)}),
                          MeshSize<2>(0.1));
  check("the edge of a knife", number_at<2>(knife, {1., 0.1}) == 1);
  check("no smooth bend, no foot of another wall, no wall that slips", points.size() == 4);

  // A box of 2 × 1 × 1 mesh sizes on a floor of two triangles.
  std::vector<WallFacet<3>> facets;
  const auto quadrangle = [&](const Point<3> &a, const Tensor<1, 3> &u, const Tensor<1, 3> &v) {
    facets.push_back({{{a, a + u, a + u + v}}, true, 0, false, true});
    facets.push_back({{{a, a + u + v, a + v}}, true, 0, false, true});
  };
  const Point<3> o(0., 0., 0.), x(2., 0., 0.), y(0., 1., 0.), z(0., 0., 1.);
  quadrangle(Point<3>(-5., -5., 0.), Point<3>(10., 0., 0.), Point<3>(0., 10., 0.));
  quadrangle(o, x, z);
  quadrangle(y, x, z);
  quadrangle(o, y, z);
  quadrangle(x, y, z);
  quadrangle(z, x, y);
  const auto of_box = points_on_sharp_edges(Walls<3>(facets), MeshSize<3>(1.));
  std::vector<Point<3>> above;
  unsigned int n_inside = 0;
  for (const auto &[p, boundary] : of_box)
    if (std::abs(p[0]) < 4.9 && std::abs(p[1]) < 4.9)
    {
      n_inside += (p[2] < 0.5);
      if (std::none_of(above.begin(), above.end(),
                       [&p = p](const Point<3> &q) { return p.distance(q) < 1e-12; }))
        above.push_back(p);
    }
  // 4 upright edges with two ends each, and the middles of the two long edges on top.
  check("edges of the box, not its feet between the corners, not the diagonals", above.size() == 10);
  check("the feet of the upright edges", n_inside == 4);
  check("the floor's rim", std::any_of(of_box.begin(), of_box.end(), [](const auto &point) {
          return point.first.distance(Point<3>(-5., 0., 0.)) < 1e-12;
        }));
}

int main()
{
  test_sticking();
  test_sides();
  test_joints();
  test_bulge();
  test_ground();
  test_edge();
  test_moving();
  test_sharp_edges();
  return n_failed > 0;
}
