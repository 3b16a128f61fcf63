// SPDX-License-Identifier: GPL-3.0-or-later

// Test the augmentation parameter that the program chooses: it follows the fluid's depth, the density, the viscosity and the
// time step, and is of the fluids that ask for it only.

#include <lahar/simulator/automatic_augmentation.h>

#include "material/laws.h"
#include "two_layers.h"

using namespace Tests;

constexpr double side = 8., density = 1700., viscosity = 30., yield_stress = 2500.;

std::unique_ptr<FluidLaw> make(const std::string &augmentation, const std::string &yield = "exact")
{
  return make_law("Bingham", {{"Yield", yield},
                              {"Density", "1700"},
                              {"Plastic viscosity", "30"},
                              {"Yield stress", "2500"},
                              {"Augmentation parameter", augmentation}});
}

/// A square with cells of one fluid or of two, one on the other.
struct Square
{
  ParticleCloud<2> cloud;
  FluidMesh<2> mesh;

  Square(const bool two)
  {
    constexpr unsigned int n = 8;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        cloud.append(Point<2>(i, j) / double(n), ParticleKind::fluid, 1. / n);
    mesh_layers(cloud, two, mesh);
    for (Point<2> &position : cloud.position)
      position *= side;
  }

  void choose(const std::vector<FluidLaw *> &laws, const double time_step) const
  {
    choose_augmentations(mesh, cloud, time_step, MPI_COMM_SELF, laws);
  }
};

/// r τ0 over μ + ρ L²/Δt.
double ratio(const FluidLaw &law, const double length, const double time_step)
{
  return law.augmentation() * yield_stress / (viscosity + density * length * length / time_step);
}

int main()
{
  const double below = 400. * std::sqrt(0.5) * (1. - 1e-12), above = 400. * std::sqrt(2.) * (1. + 1e-12);
  const auto law = make("auto");
  Square square(false);
  double least = 1e300, most = 0.;
  bool powers = true;
  for (double time_step = 1e-4; time_step < 1e4; time_step *= 3.)
  {
    square.choose({law.get()}, time_step);
    least  = std::min(least, ratio(*law, 0.5 * side, time_step));
    most   = std::max(most, ratio(*law, 0.5 * side, time_step));
    powers = powers && std::log2(law->augmentation()) == std::round(std::log2(law->augmentation()));
  }
  check("r follows half the depth of a block and the time step", least > below && most < above);
  check("to a power of two", powers);

  const auto given = make("70"), regularized = make("auto", "Papanastasiou");
  Square layers(true);
  layers.choose({law.get(), given.get()}, 0.1);
  // Of a layer 8 m wide and 4 m deep three sides are free.
  const double of_layer = ratio(*law, 2. * 32. / 16., 0.1);
  check("of several fluids that of each", of_layer > below && of_layer < above);
  check("r that is given stays", given->augmentation() - 70., 0.);
  square.choose({regularized.get()}, 0.1);
  check("so does none", regularized->augmentation(), 0.);
  return n_failed > 0;
}
