// SPDX-License-Identifier: GPL-3.0-or-later

// Test contact with a surface of a solid that deforms in a step: which particles it meets, where they land and how fast
// they are then, and that nothing is prescribed for them but by walls.

#include <lahar/boundary/solid_touch.h>
#include <lahar/boundary/wall_contact.h>

#include "tests.h"

using namespace Tests;

constexpr double h = 0.1, time_step = 0.1;

/// A facet of a solid, the boundary number 1.
template <int dim>
WallFacet<dim> facet(const std::array<Point<dim>, dim> &corners)
{
  return {corners, true, 1, false, false};
}

template <int dim>
unsigned int append(ParticleCloud<dim> &cloud, const Point<dim> &end, const Tensor<1, dim> &velocity)
{
  const unsigned int i = cloud.append(end, ParticleKind::fluid, h);
  cloud.velocity[i]    = velocity;
  return i;
}

void test_plane()
{
  // A floor, and a solid's facet above it that turns about its right end: down at its left end.
  const Walls<2> walls({{{{Point<2>(-5., -1.), Point<2>(5., -1.)}}, true, 0, false, true}}, {"floor"});
  const std::vector<WallFacet<2>> start = {facet<2>({{{1., 0.}, {0., 0.}}})},
                                  end   = {facet<2>({{{1., 0.}, {0., -0.1}}})};
  const WallStep<2> standing(walls), step = standing.with_solids(start, end, time_step);
  check("what deforms", !step.deforms(0) && step.deforms(1) && !step.facet_moves(1) && step.any_moves());
  check("velocity of its points",
        (step.facet_velocity_at_end(1, {0., -0.1}) - Point<2>(0., -1.)).norm() +
          step.facet_velocity_at_end(1, {1., 0.}).norm(),
        1e-14);

  // Its normal points down, out of the solid. The first one stands before the left end, the second is beyond the
  // place where the facet comes, the third flees as fast as the facet.
  const Tensor<1, 2> normal        = step.end().normal(1);
  const std::vector<Point<2>> from = {{0.1, -0.05}, {0.1, -0.15}, {0.1, -0.01}};
  ParticleCloud<2> cloud;
  append(cloud, from[0], Tensor<1, 2>());
  append(cloud, from[1], Tensor<1, 2>());
  append(cloud, Point<2>(0.1, -0.115), Point<2>(0., -1.05));
  const auto crossed = [&](const unsigned int i) {
    return !step.crossed(from[i], cloud.position[i], 0., 1e-3 * h).empty();
  };
  check("what it meets", crossed(0) && !crossed(1) && !crossed(2));
  WallContact<2>(step).update(from, cloud);
  check("it has landed, the others have not",
        cloud.in_contact(0) && !cloud.in_contact(1) && cloud.contact_facets[0][0] == 1);
  check("outside of the solid", step.end().signed_distance(1, cloud.position[0]) - contact_offset * h, 1e-15);
  check("with the normal velocity of the facet there",
        normal * (cloud.velocity[0] - step.facet_velocity_at_end(1, cloud.position[0])), 1e-14);
  check("nothing is prescribed", WallContact<2>(step).constraint(0, cloud).n_fixed == 0);

  // In the corner of the two.
  cloud.contact_facets[0]           = {{0, 1}};
  const NodeConstraint<2> in_corner = WallContact<2>(step).constraint(0, cloud);
  check("beside a wall that it would stick to, the wall's normal",
        in_corner.n_fixed == 1 && std::abs(in_corner.frame[0] * Point<2>(0., 1.)) > 1. - 1e-14);
}

void test_space()
{
  const Walls<3> walls;
  const std::array<Point<3>, 3> corners = {
    {Point<3>(0., 0., 0.), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.)}};
  std::array<Point<3>, 3> moved = corners;
  moved[0][2]                   = 0.3; // it rises at one corner and shears
  moved[1][1]                   = 0.2;
  const WallStep<3> step = WallStep<3>(walls).with_solids({facet<3>(corners)}, {facet<3>(moved)}, time_step);
  ParticleCloud<3> cloud;
  const std::vector<Point<3>> from = {{0.2, 0.2, 0.05}, {0.2, 0.2, 0.25}};
  append(cloud, from[0], Tensor<1, 3>());
  append(cloud, from[1], Tensor<1, 3>());
  WallContact<3>(step).update(from, cloud);
  check("3D: it lifts what is in its way only", cloud.in_contact(0) && !cloud.in_contact(1));
  check("3D: on its upper side", step.end().signed_distance(0, cloud.position[0]) - contact_offset * h,
        1e-15);
  check("3D: the velocity of its points",
        (step.facet_velocity_at_end(0, moved[1]) - Point<3>(0., 2., 0.)).norm() +
          (step.facet_velocity_at_end(0, moved[2])).norm(),
        1e-13);
}

int main()
{
  test_plane();
  test_space();
  return n_failed;
}
