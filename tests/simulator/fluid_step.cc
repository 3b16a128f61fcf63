// Test what FluidStep tells of crushed cells: a vertex that falls on a moving floor, between two others that do not.

#include <lahar/simulator/fluid_step.h>

#include "tests.h"

using namespace Tests;

int main()
{
  // Vertices 0 and 1 on the floor, 2 above them, 3 and 4 above its sides.
  ParticleCloud<2> cloud;
  for (const auto &[x, y] : std::vector<std::pair<double, double>>{{0, 0}, {2, 0}, {1, 1}, {0, 2}, {2, 2}})
    cloud.append(Point<2>(x, y), ParticleKind::fluid, 1.);
  cloud.velocity[0] = Point<2>(0.25, 0.);
  cloud.velocity[1] = Point<2>(0.75, 0.);
  FluidMesh<2> mesh;
  mesh.reinit(cloud, {{0, 1, 2}, {2, 4, 3}, {0, 2, 3}});

  TimeIntegration integration;
  integration.start_step(1., true);
  FluidStep<2> step;
  step.start(mesh, cloud, integration, std::vector<bool>(5, true)); // x = x_n + v Δt
  unsigned int falling = 0;
  while (mesh.particle(falling) != 2)
    ++falling;
  const auto fall = [&](const double depth) {
    std::vector<Tensor<1, 2>> velocities = step.state.old_velocity;
    velocities[falling]                  = Point<2>(0., -depth);
    step.move(velocities);
  };

  // The floor widens from 2 to 2.5.
  fall(0.4);
  check("a cell that keeps 3/4 is not crushed", step.obstacle_velocities({falling}).empty());
  fall(0.5);
  const auto obstacles = step.obstacle_velocities({falling});
  check("one that keeps 5/8 is", obstacles.size() == 1);
  check("the mean of the other corners' velocities", (obstacles.at(falling) - Point<2>(0.5, 0.)).norm(),
        1e-15);
  check("not of other vertices that run into it", step.obstacle_velocities({0, 1, 2, 3, 4}).empty());

  // After 0.9 of the way an eighth of the cell is left, after 3/4 of that 0.41.
  fall(0.9);
  check("the flat cell's vertices", step.shrinking_vertices(step.old_volumes()).size() == 3);
  std::vector<double> parts(5, 0.);
  parts[falling] = 1.;
  step.shorten_motions(step.old_volumes(), parts,
                       [](const unsigned int, const double part) { return Point<2>(0., -0.9 * part); });
  check("the motion is shortened by a quarter", parts[falling] - 0.75, 0.);
  check("and done", step.state.position[falling].distance(Point<2>(1., 1. - 0.9 * 0.75)), 1e-15);
  check("no cell is flat", step.shrinking_vertices(step.old_volumes()).empty());

  fall(0.9);
  parts.assign(5, 0.);
  step.shorten_motions(step.old_volumes(), parts,
                       [](const unsigned int, const double) { return Tensor<1, 2>(); });
  check("motions that may not be shortened stay", step.state.position[falling].distance(Point<2>(1., 0.1)),
        1e-15);
  return n_failed;
}
