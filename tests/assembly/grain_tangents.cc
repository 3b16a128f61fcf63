// SPDX-License-Identifier: GPL-3.0-or-later

// Test the stress of laws that depend on the pressure, in 2D, with rotational symmetry and in 3D: Jacobians against central
// differences, in air and under water, the columns of the pressure, and the pressure between grains in still water.

#include <lahar/assembly/fluid_assembler.h>

#include "assembly/example_cell.h"

using namespace Tests;

/// Primal-dual has all of the derivative with respect to the pressure, whatever Λ is; Picard has none of it.
template <int dim>
void check_pressure_columns(const FluidLaw &law)
{
  using S = CellSystem<dim>;
  Random random;
  double error = 0., size = 0., picard_size = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    Example<dim> example(random, law, false, -3.);
    const auto picard = example.system(assembler(ViscousStress<dim>(ViscosityLinearization::picard))).matrix;
    const auto newton = example.system(assembler(ViscousStress<dim>(ViscosityLinearization::newton))).matrix;
    const auto dual =
      example.system(assembler(ViscousStress<dim>(ViscosityLinearization::primal_dual, 0.7))).matrix;
    for (unsigned int i = 0; i < newton.size(); ++i)
      for (unsigned int J = 0; J <= dim; ++J)
      {
        const unsigned int j = S::pressure_index(J);
        error                = std::max(error, std::abs(dual[i][j] - newton[i][j]));
        size                 = std::max(size, std::abs(newton[i][j]));
        picard_size          = std::max(picard_size, std::abs(picard[i][j]));
      }
  }
  const std::string name = name_of<dim>() + " derivative with respect to the pressure: ";
  check(name + "there is one", size > 0.01);
  check(name + "primal-dual has Newton's", error, 0.);
  check(name + "Picard has none", picard_size, 0.);
}

/// Laws that depend on the pressure, compressed and in tension.
template <int dim>
void check_grains()
{
  const Entries grains = {{"Density", "1.3"}, {"Grain density", "2"}, {"Grain diameter", "0.2"}};
  const auto with      = [&](const Entries &more) {
    Entries all = grains;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const auto soil = make_law("Drucker-Prager", {{"Density", "1.3"},
                                                {"Cohesion", "0.5"},
                                                {"Friction angle", "35"},
                                                {"Viscosity", "0.7"},
                                                {"Regularization parameter", "3"}}),
             sand =
               make_law("mu(I)",
                        with({{"Cohesion", "0.5"}, {"Viscosity", "0.7"}, {"Regularization parameter", "3"}})),
             creep = make_law("mu(I) Barker-Gray",
                              with({{"Smallest strain rate", "0.1"}, {"Viscosity", "0.7"}}));
  for (const double mean_pressure : {-3., 3.})
  {
    const std::string state = mean_pressure < 0. ? ", compressed" : ", in tension";
    const auto term         = assembler(ViscousStress<dim>(ViscosityLinearization::newton));
    check_jacobian<dim>("viscous stress, Drucker-Prager, newton" + state, *soil, term, mean_pressure);
    check_jacobian<dim>("viscous stress, mu(I), newton" + state, *sand, term, mean_pressure);
    check_jacobian<dim>("viscous stress, Barker-Gray, newton" + state, *creep, term, mean_pressure);
  }
  check_pressure_columns<dim>(*sand);
}

/// Grains whose pores are full of water: up to a level above the cell, and up to one in it.
template <int dim>
void check_pore_water()
{
  for (const double level : {2., -0.1})
  {
    const auto with = [&](Entries entries) {
      entries.insert(entries.end(), {{"Density", "1.3"},
                                     {"Viscosity", "0.7"},
                                     {"Pore water level", std::to_string(level)},
                                     {"Pore water density", "0.6"}});
      return entries;
    };
    const Entries grains = {{"Grain density", "2"}, {"Grain diameter", "0.2"}};
    const auto soil =
      make_law("Drucker-Prager",
               with({{"Cohesion", "0.5"}, {"Friction angle", "35"}, {"Regularization parameter", "3"}}));
    Entries sandy = with(grains);
    sandy.push_back({"Regularization parameter", "3"});
    const auto sand = make_law("mu(I)", sandy);
    Entries creepy  = with(grains);
    creepy.push_back({"Smallest strain rate", "0.1"});
    const auto creep       = make_law("mu(I) Barker-Gray", creepy);
    const auto term        = assembler(ViscousStress<dim>(ViscosityLinearization::newton));
    const std::string name = level > 0. ? ", under water" : ", at the level of the water";
    check_jacobian<dim>("viscous stress, Drucker-Prager, newton" + name, *soil, term, -5.);
    check_jacobian<dim>("viscous stress, mu(I), newton" + name, *sand, term, -5.);
    check_jacobian<dim>("viscous stress, Barker-Gray, newton" + name, *creep, term, -5.);

    // At rest grains bear what they weigh above the water that they displace; in water alone nothing.
    Random random;
    double error = 0., in_water = 0., least = 1e10, most = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
    {
      Example<dim> example(random, *soil);
      auto &state        = example.state;
      const double g     = state.gravity.norm();
      const auto p_water = [&](const Point<dim> &x) {
        return 0.6 * std::max(level * g + state.gravity * x, 0.);
      };
      double P = 0.;
      for (unsigned int I = 0; I <= dim; ++I)
      {
        const double of_grains = 0.7 * (5. * g + state.gravity * state.position[I]);
        state.pressure[I]      = -of_grains - p_water(state.position[I]);
        P += of_grains / (dim + 1);
      }
      error = std::max(error, std::abs(example.cell().confining_pressure() - P));
      least = std::min(least, P);
      for (unsigned int I = 0; I <= dim; ++I)
      {
        state.pressure[I] = -p_water(state.position[I]);
        most              = std::max(most, p_water(state.position[I]));
      }
      in_water = std::max(in_water, example.cell().confining_pressure());
    }
    check(name_of<dim>() + " pressure between grains" + name, error, 1e-13);
    check(name_of<dim>() + " pressure between grains" + name + ": water alone makes none", in_water, 1e-13);
    check(name_of<dim>() + " pressure between grains" + name + ": ... though there is both",
          least > 0.01 && most > 0.01);
  }
}

template <int dim>
void test()
{
  check_grains<dim>();
  check_pore_water<dim>();
}

int main()
{
  test<2>();
  Symmetry::set_rotational(true);
  test<2>();
  Symmetry::set_rotational(false);
  test<3>();
  return n_failed;
}
