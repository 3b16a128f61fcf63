// SPDX-License-Identifier: GPL-3.0-or-later

// Test the structure of thixotropic fluids on particles and cells: simple shear has the closed forms whatever the mesh is,
// fluids that touch keep theirs apart, particles that are new, and walls that are reached, get what is around them, and
// remeshing makes no structure that was not there.

#include <lahar/assembly/fluid_structure.h>
#include <lahar/geometry/simplex_geometry.h>
#include <lahar/particles/fluid_set.h>
#include <lahar/remeshing/remesher.h>

#include <algorithm>

#include "tests.h"
#include "two_layers.h"

using namespace Tests;

constexpr unsigned int n = 10;

/// Two fluids, the second one above y = 1/2, in the unit square, with walls at its bottom.
struct Layers
{
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;
  Migration<2> alone;

  explicit Layers(const Materials &materials)
  {
    Random random;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
      {
        Point<2> x(i / double(n), j / double(n));
        if (i > 0 && i < n && j > 0 && j < n)
          x += 0.2 / n * Point<2>(random.number(), 2 * j == n ? 0. : random.number());
        cloud.append(x, j == 0 ? ParticleKind::wall : ParticleKind::fluid, 1. / n,
                     j == 0                                   ? 0U
                     : materials.n_fluids() == 1 || 2 * j < n ? 1U
                     : 2 * j > n                              ? 2U
                                                              : 3U);
      }
    mesh_layers(cloud, materials.n_fluids() > 1, mesh);
    FluidStructure<2>::prepare(materials, cloud);
    FluidStructure<2>::complete(mesh, materials, alone, cloud);
  }
};

std::unique_ptr<FluidLaw> make(const std::string &T, const std::string &alpha, const std::string &initial)
{
  return make_law("Bingham", {{"Flocculation time", T},
                              {"Deflocculation parameter", alpha},
                              {"Initial structure", initial}});
}

/// Largest error of the cells of a fluid.
double error_of(const Layers &layers, const Materials &materials, const unsigned int fluid,
                const double expected)
{
  const std::vector<double> found = FluidStructure<2>::of_cells(layers.mesh, materials, layers.cloud);
  double error                    = 0.;
  for (unsigned int c = 0; c < found.size(); ++c)
    if (layers.mesh.fluid(c) == fluid)
      error = std::max(error, std::abs(found[c] - expected) / std::max(1e-300, std::abs(expected)));
  return error;
}

void test_shear()
{
  const auto lower = make("10", "0.5", "3"), upper = make("2", "0.1", "0"),
             newton = make_law("Newtonian", {});
  const Materials two({lower.get(), upper.get()}), one_of_two({lower.get(), newton.get()});
  constexpr double rate = 4., time_step = 0.05;
  for (const double of_rate : {0., 1.})
  {
    Layers layers(two);
    const double gamma = of_rate * rate;
    for (unsigned int i = 0; i < layers.cloud.size(); ++i)
      layers.cloud.velocity[i] = Point<2>(gamma * layers.cloud.position[i][1], 0.);
    const auto exact = [&](const double T, const double alpha, const double initial, const double t) {
      if (gamma == 0.)
        return initial + t / T;
      const double limit = 1. / (T * alpha * gamma);
      return limit + (initial - limit) * std::exp(-alpha * gamma * t);
    };
    const std::string name = gamma == 0. ? "at rest: " : "simple shear: ";
    check(name + "initial structures", error_of(layers, two, 0, 3.) + error_of(layers, two, 1, 0.), 0.);
    double time = 0.;
    for (const unsigned int n_steps : {7, 1000})
    {
      for (unsigned int step = 0; step < n_steps; ++step, time += time_step)
        FluidStructure<2>::advance(layers.mesh, two, time_step, layers.alone, layers.cloud);
      const std::string after = name + (n_steps == 7 ? "on the way" : "in the end");
      check(after + ", lower fluid", error_of(layers, two, 0, exact(10., 0.5, 3., time)), 1e-11);
      check(after + ", upper fluid", error_of(layers, two, 1, exact(2., 0.1, 0., time)), 1e-11);
    }
  }
  const Layers layers(one_of_two);
  check("a fluid without thixotropy has none", error_of(layers, one_of_two, 1, 0.), 0.);
  check("nor have its particles", layers.cloud.structure[0].back() == ParticleCloud<2>::no_structure &&
                                    layers.cloud.structure[0][0] == 3.);
}

void test_remeshing()
{
  const auto law = make("10", "0.5", "3"), other = make("2", "0.1", "0");
  for (const bool several : {false, true})
  {
    const Materials materials = several ? Materials({law.get(), other.get()}) : Materials(*law);
    Layers layers(materials);
    Random random;
    std::array<double, 2> least, largest;
    for (unsigned int fluid = 0; fluid < materials.n_fluids(); ++fluid)
    {
      for (double &structure : layers.cloud.structure[fluid])
        if (structure >= 0.)
          structure = 5. + random.number();
      least[fluid] = 1e9, largest[fluid] = 0.;
      for (const double structure : layers.cloud.structure[fluid])
        if (structure >= 0.)
        {
          least[fluid]   = std::min(least[fluid], structure);
          largest[fluid] = std::max(largest[fluid], structure);
        }
    }
    Remesher<2> remesher;
    parse(remesher, "");
    remesher.set_number_of_fluids(materials.n_fluids());
    bool within = true, complete = true;
    const std::uint64_t first_new = layers.cloud.next_number;
    for (unsigned int step = 0; step < 30; ++step)
    {
      for (unsigned int i = 0; i < layers.cloud.size(); ++i)
      {
        Point<2> &x = layers.cloud.position[i];
        if (layers.cloud.kind[i] == ParticleKind::fluid)
          x += 0.02 * Tensor<1, 2>({std::sin(numbers::PI * x[0]) * std::cos(numbers::PI * x[1]) + 0.5 * x[1],
                                    -std::cos(numbers::PI * x[0]) * std::sin(numbers::PI * x[1])});
      }
      layers.mesh.move(layers.cloud);
      remesher.remesh(layers.cloud, Walls<2>(), {}, 1e-3, layers.mesh);
      FluidStructure<2>::complete(layers.mesh, materials, layers.alone, layers.cloud);
      for (unsigned int fluid = 0; fluid < materials.n_fluids(); ++fluid)
        for (const double structure : layers.cloud.structure[fluid])
          within = within && (structure == ParticleCloud<2>::no_structure ||
                              (structure >= least[fluid] && structure <= largest[fluid]));
      for (unsigned int c = 0; c < layers.mesh.n_cells(); ++c)
        for (const unsigned int i : layers.mesh.particle_cells()[c])
          complete = complete && layers.cloud.structure[layers.mesh.fluid(c)][i] >= 0.;
    }
    const std::string name = several ? "two fluids: " : "one fluid: ";
    check(name + "particles are new", layers.cloud.next_number > first_new + 5);
    check(name + "no structure below or above that of the start", within);
    check(name + "all corners have that of their fluids", complete);
  }
}

void test_walls()
{
  const auto law = make("10", "0.5", "3");
  const Materials materials(*law);
  Layers layers(materials);
  for (double &structure : layers.cloud.structure[0])
    structure = structure >= 0. ? 4. : structure;
  layers.cloud.structure[0][3]   = ParticleCloud<2>::no_structure; // a wall
  const unsigned int dry         = layers.cloud.append(Point<2>(3., 0.), ParticleKind::wall, 0.1),
                     drop        = layers.cloud.append(Point<2>(3., 3.), ParticleKind::fluid, 0.1, 1);
  layers.cloud.structure[0][dry] = 4.;
  FluidStructure<2>::complete(layers.mesh, materials, layers.alone, layers.cloud);
  check("a wall that fluid reaches has its structure", layers.cloud.structure[0][3] - 4., 1e-14);
  check("one without a cell has none", layers.cloud.structure[0][dry] == ParticleCloud<2>::no_structure);
  check("fluid that has come in has that of the start", layers.cloud.structure[0][drop] == 3.);
  FluidStructure<2>::advance(layers.mesh, materials, 2., layers.alone, layers.cloud);
  check("a drop rests", layers.cloud.structure[0][drop] - 3.2, 1e-14);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_shear();
  test_remeshing();
  test_walls();
  return n_failed;
}
