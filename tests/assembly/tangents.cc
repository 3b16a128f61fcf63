// SPDX-License-Identifier: GPL-3.0-or-later

// Test every term of the weak form in 2D, with rotational symmetry and in 3D: its Jacobian against central differences of
// its residual, where the nodes move with their velocities, and the identities that the residuals obey.

#include <lahar/assembly/exact_plastic_stress.h>
#include <lahar/assembly/fluid_assembler.h>

#include "assembly/example_cell.h"

using namespace Tests;

/// Primal-dual with Λ = 2 f e' must be Newton, at most with less weight on the plastic rank-one part.
template <int dim, typename Term>
void check_primal_dual(const std::string &what, const FluidLaw &law, const double mean_pressure = 0.)
{
  Random random;
  double error = 0., lowest = 1e10, highest = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    Example<dim> example(random, law, false, mean_pressure);
    const FluidCell<dim> cell     = example.cell();
    example.state.plastic_dual[0] = 2. * law.plastic_part(cell.plastic_strain_rate()).value *
                                    cell.plastic_rate();
    const auto picard = example.system(assembler(Term(ViscosityLinearization::picard))).matrix;
    const auto newton = example.system(assembler(Term(ViscosityLinearization::newton))).matrix;
    const auto dual   = example.system(assembler(Term(ViscosityLinearization::primal_dual))).matrix;
    double product = 0., square = 0., size = 0.;
    for (unsigned int i = 0; i < newton.size(); ++i)
      for (unsigned int j = 0; j < newton.size(); ++j)
      {
        product += (dual[i][j] - picard[i][j]) * (newton[i][j] - picard[i][j]);
        square += std::pow(newton[i][j] - picard[i][j], 2);
        size = std::max(size, std::abs(newton[i][j]));
      }
    if (square == 0.) // all of a rigid cell's stiffness is in both
      continue;
    const double weight = product / square;
    lowest              = std::min(lowest, weight);
    highest             = std::max(highest, weight);
    for (unsigned int i = 0; i < newton.size(); ++i)
      for (unsigned int j = 0; j < newton.size(); ++j)
        error = std::max(error,
                         std::abs(dual[i][j] - (1. - weight) * picard[i][j] - weight * newton[i][j]) / size);
  }
  const std::string name = name_of<dim>() + " primal-dual tangent" + what + " ";
  check(name + "lies between Picard and Newton", error, 1e-12);
  check(name + "has one weight", highest - lowest, 1e-10);
  check(name + "has a weight from 0.8 to 1", lowest > 0.8 && highest < 1. + 1e-10);
}

/// The plastic stress of an exact yield stress.
template <int dim>
void check_exact_stress(const FluidLaw &law)
{
  const std::string name = Utilities::int_to_string(dim) + "D exact yield stress: ";
  Random random;
  double error = 0., fixed_point = 0., largest = 0., rigid = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    Example<dim> example(random, law);
    const FluidCell<dim> flowing = example.cell();
    const double tau_0 = law.yield_stress(0.).value, rate = flowing.strain_rate();
    SymmetricTensor<2, dim> &multiplier = example.state.multiplier[0];
    const auto plastic_error            = [&](const SymmetricTensor<2, dim> &stress) {
      const FluidCell<dim> cell = example.cell();
      const auto residual =
        example.system(assembler(ExactPlasticStress<dim>(ViscosityLinearization::newton))).residual;
      double difference = 0.;
      for (unsigned int I = 0; I <= dim; ++I)
        for (unsigned int a = 0; a < dim; ++a)
          difference = std::max(difference, std::abs(residual[CellSystem<dim>::index(I, a)] -
                                                                cell.volume() * (stress * cell.gradients()[I])[a]));
      return difference;
    };
    largest = std::max(largest, deviator_norm<dim>(project_deviator<dim>(multiplier)));
    // Any multiplier: |P(X)| ≤ 1 and no viscous part.
    multiplier  = SymmetricTensor<2, dim>();
    error       = std::max(error, plastic_error(2. * tau_0 * std::min(law.augmentation(), 1. / rate) *
                                                flowing.deviator()));
    multiplier  = 2. / rate * flowing.deviator(); // that of flow at this rate
    fixed_point = std::max(fixed_point, plastic_error(tau_0 * multiplier));
    // At rest the stress is the multiplier.
    multiplier *= 0.9;
    example.state.velocity.assign(dim + 1, Tensor<1, dim>());
    example.state.position = example.state.old_position;
    rigid                  = std::max(rigid, plastic_error(tau_0 * multiplier));
  }
  check(name + "without multiplier it is that of a biviscous fluid", error, 1e-12);
  check(name + "with that of the flow it is Bingham's", fixed_point, 1e-12);
  check(name + "at rest it is the multiplier's", rigid, 1e-12);
  check(name + "projections have at most the length one", largest <= 1. + 1e-14);
}

/// What an update of the multipliers adds to the work of the residual along an increment.
template <int dim>
void check_update(const FluidLaw &law, const std::string &what)
{
  using S = CellSystem<dim>;
  Random random;
  double error = 0., size = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    Example<dim> example(random, law);
    example.state.structure = {0.4};
    ParticleCloud<dim> cloud;
    Simplex<dim> cell;
    std::vector<Tensor<1, dim>> increment;
    for (unsigned int I = 0; I <= dim; ++I)
    {
      cloud.append(example.state.position[I], ParticleKind::fluid, 1.);
      cell[I] = I;
      increment.push_back(random.vector<dim>());
    }
    FluidMesh<dim> mesh;
    mesh.reinit(cloud, {cell});
    const auto work = [&]() {
      const auto residual =
        example.system(assembler(ExactPlasticStress<dim>(ViscosityLinearization::newton))).residual;
      double sum = 0.;
      for (unsigned int I = 0; I <= dim; ++I)
        for (unsigned int a = 0; a < dim; ++a)
          sum += residual[S::index(I, a)] * increment[I][a];
      return sum;
    };
    const double before = work(), change = FluidAssembler<dim>().update_multipliers(mesh, law, example.state,
                                                                                    increment, {true});
    error = std::max(error, std::abs(work() - before - change));
    size  = std::max(size, std::abs(change));
  }
  check(name_of<dim>() + what + ": an update of the multipliers changes something", size > 0.01);
  check(name_of<dim>() + what + ": by what it says", error, 1e-12);
}

template <int dim>
void check_identities(const FluidLaw &law)
{
  using S                = CellSystem<dim>;
  const std::string name = Utilities::int_to_string(dim) + "D ";
  Random random;
  Example<dim> example(random, law);
  FluidState<dim> &state    = example.state;
  const FluidCell<dim> cell = example.cell();

  const auto sum = [&](const auto &term) {
    Tensor<1, dim + 1> total;
    const CellSystem<dim> system = example.system(assembler(term));
    for (unsigned int i = 0; i < S::n_unknowns; ++i)
      total[i % (dim + 1)] += system.residual[i];
    return total;
  };
  const auto in_velocity = [](const Tensor<1, dim> &v) {
    Tensor<1, dim + 1> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = v[d];
    return result;
  };
  const double mass = law.density() * cell.volume();
  check(name + "rows of inertia sum to m a",
        (sum(Inertia<dim>()) - in_velocity(mass * cell.mean_acceleration())).norm(), 1e-12);
  check(name + "rows of weight sum to -m g",
        (sum(BodyForce<dim>()) + in_velocity(mass * cell.gravity())).norm(), 1e-13);
  check(name + "rows of viscous stress sum to zero",
        sum(ViscousStress<dim>(ViscosityLinearization::newton)).norm(), 1e-12);
  Tensor<1, dim + 1> rate;
  for (unsigned int I = 0; I <= dim; ++I)
    rate[dim] += law.compressibility() * cell.volume() / (dim + 1) *
                 (cell.pressure()[I] - cell.old_pressure()[I]) / cell.time_step();
  rate[dim] -= (cell.volume() - cell.old_volume()) / cell.time_step();
  check(name + "rows of pressure and divergence sum to the balance of mass",
        (sum(PressureDivergence<dim>()) - rate).norm(), 1e-12);
  check(name + "rows of the residual stabilisation sum to zero", sum(ResidualStabilization<dim>()).norm(),
        1e-12);

  // A rigid motion, with the positions held: no viscous force, not even in a plug.
  Tensor<2, dim> spin;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = 0; b < a; ++b)
      spin[b][a] = -(spin[a][b] = random.number());
  const Tensor<1, dim> translation = random.vector<dim>();
  for (unsigned int I = 0; I <= dim; ++I)
    state.velocity[I] = translation + spin * state.old_position[I];
  state.position   = state.old_position;
  const auto rigid = example.system(assembler(ViscousStress<dim>(ViscosityLinearization::newton))).residual;
  check(name + "rigid motion makes no viscous force", *std::max_element(rigid.begin(), rigid.end()), 1e-12);

  // A fluid at rest with the pressure of its weight (positive in tension).
  for (unsigned int I = 0; I <= dim; ++I)
  {
    state.velocity[I] = state.acceleration[I] = Tensor<1, dim>();
    state.pressure[I] = state.old_pressure[I] = -law.density() * (state.gravity * state.old_position[I]);
    state.old_pressure_rate[I]                = 0.;
  }
  double mass_residual = 0.;
  for (const auto &residual : {example.system(assembler(FICInterior<dim>())).residual,
                               example.system(assembler(ResidualStabilization<dim>())).residual})
    for (unsigned int I = 0; I <= dim; ++I)
      mass_residual = std::max(mass_residual, std::abs(residual[S::pressure_index(I)]));
  check(name + "hydrostatic pressure leaves no mass residual", mass_residual, 1e-13);
}

/// The Jacobians that are there with rotational symmetry, too.
template <int dim>
void check_jacobians(const FluidLaw &bingham, const FluidLaw &newtonian)
{
  check_jacobian<dim>("inertia", bingham, assembler(Inertia<dim>()));
  check_jacobian<dim>("weight", bingham, assembler(BodyForce<dim>()));
  check_jacobian<dim>("viscous stress, Bingham, newton", bingham,
                      assembler(ViscousStress<dim>(ViscosityLinearization::newton)));
  const auto thinning = make_law("Herschel-Bulkley", {{"Density", "1.3"},
                                                      {"Consistency", "0.7"},
                                                      {"Flow index", "0.4"},
                                                      {"Yield stress", "2"},
                                                      {"Regularization parameter", "3"}});
  check_jacobian<dim>("viscous stress, Herschel-Bulkley, newton", *thinning,
                      assembler(ViscousStress<dim>(ViscosityLinearization::newton)));
  for (const auto linearization :
       {ViscosityLinearization::picard, ViscosityLinearization::newton, ViscosityLinearization::primal_dual})
    check_jacobian<dim>("viscous stress, Newtonian", newtonian, assembler(ViscousStress<dim>(linearization)));
  check_jacobian<dim>("pressure and divergence", bingham, assembler(PressureDivergence<dim>()));
  check_jacobian<dim>("FIC inside", bingham, assembler(FICInterior<dim>()));
  check_jacobian<dim>("residual stabilisation", bingham, assembler(ResidualStabilization<dim>()));
}

/// A yield stress that is not regularised, with short and long steps of the multipliers.
template <int dim>
void check_exact()
{
  for (const char *augmentation : {"0.2", "3"})
  {
    const std::string name = std::string(", r = ") + augmentation;
    const auto exact       = make_law("Herschel-Bulkley", {{"Density", "1.3"},
                                                           {"Consistency", "0.7"},
                                                           {"Flow index", "0.4"},
                                                           {"Yield stress", "2"},
                                                           {"Yield", "exact"},
                                                           {"Augmentation parameter", augmentation}});
    check_jacobian<dim>("exact yield stress, plastic part" + name, *exact,
                        assembler(ExactPlasticStress<dim>(ViscosityLinearization::newton)));
    check_jacobian<dim>("exact yield stress, viscous part" + name, *exact,
                        assembler(ViscousStress<dim>(ViscosityLinearization::newton)));
    check_primal_dual<dim, ExactPlasticStress<dim>>(", exact yield stress" + name, *exact);
    check_update<dim>(*exact, " exact yield stress" + name);
    if (!Symmetry::applies<dim>())
      check_exact_stress<dim>(*exact);
  }
}

/// A pressure that is given on a face: its Jacobian, and that all faces together press with −V ∇p.
template <int dim>
void check_prescribed_pressure(const FluidLaw &law)
{
  Random random;
  double error = 0., sum_error = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    Example<dim> example(random, law, sample % 2);
    FacePressure<dim> pressure;
    pressure.at_origin = 8.;
    pressure.gradient  = random.vector<dim>();
    Tensor<1, dim> force;
    for (unsigned int opposite = 0; opposite <= dim; ++opposite)
    {
      const auto assemble = [&](const auto &cell, auto &system) {
        SimplexCorners<dim> corners;
        std::copy_n(example.state.position.begin(), dim + 1, corners.begin());
        PrescribedPressure<dim>().assemble(cell, corners, opposite, pressure, system);
      };
      error               = std::max(error, example.jacobian_error(assemble));
      const auto residual = example.system(assemble).residual;
      for (unsigned int I = 0; I <= dim; ++I)
        for (unsigned int a = 0; a < dim; ++a)
          force[a] += residual[CellSystem<dim>::index(I, a)];
    }
    sum_error = std::max(sum_error, (force - example.cell().volume() * pressure.gradient).norm());
  }
  check(name_of<dim>() + " Jacobian: prescribed pressure on a face", error, 1e-6);
  check(name_of<dim>() + " prescribed pressure on all faces", sum_error, 1e-12);
}

template <int dim>
void test()
{
  const auto bingham   = make_law("Bingham", {{"Density", "1.3"},
                                              {"Bulk modulus", "5"},
                                              {"Plastic viscosity", "0.7"},
                                              {"Yield stress", "2"},
                                              {"Regularization parameter", "3"}});
  const auto newtonian = make_law("Newtonian", {{"Density", "1.3"}, {"Viscosity", "0.7"}});

  check_jacobians<dim>(*bingham, *newtonian);
  for (unsigned int opposite = 0; opposite <= dim; ++opposite)
    check_jacobian<dim>("FIC on the free surface, Newtonian", *newtonian,
                        [opposite](const auto &cell, auto &system) {
                          FICFreeSurface<dim>().assemble(cell, opposite, system);
                        });
  check_prescribed_pressure<dim>(*newtonian);
  check_primal_dual<dim, ViscousStress<dim>>("", *bingham);
  check_exact<dim>();
  check_identities<dim>(*bingham);
  if (dim == 3)
    return;
  Symmetry::set_rotational(true);
  check_jacobians<dim>(*bingham, *newtonian);
  check_primal_dual<dim, ViscousStress<dim>>("", *bingham);
  check_exact<dim>();
  Symmetry::set_rotational(false);
}

int main()
{
  test<2>();
  test<3>();
  return n_failed;
}
