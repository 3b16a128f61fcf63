// SPDX-License-Identifier: GPL-3.0-or-later

// Test the hypoelastic and the neo-Hookean law in two and three dimensions: tangents against central differences, rigid
// rotations, agreement with each other and with Hooke's law for small strains, stored energies, and wrong parameters.

#include <lahar/material/solid_law.h>
#include <lahar/utilities/factory.h>

#include "tests.h"

using namespace Tests;

std::unique_ptr<SolidLaw> make(const std::string &name, const Entries &entries)
{
  Parameters prm;
  SolidLaw::declare_parameters(prm);
  prm.set("Law", name);
  prm.enter_subsection(name);
  for (const auto &[entry, value] : entries)
    prm.set(entry, value);
  prm.leave_subsection();
  return SolidLaw::create(prm);
}

template <int dim>
Tensor<2, 3> random_tensor(Random &random, const double size)
{
  Tensor<2, 3> tensor;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      tensor[i][j] = size * random.number();
  return tensor;
}

Tensor<2, 3> rotation(const double angle)
{
  Tensor<2, 3> R = unit_symmetric_tensor<3>();
  R[0][0] = R[1][1] = std::cos(angle);
  R[1][0]           = std::sin(angle);
  R[0][1]           = -R[1][0];
  return R;
}

const Tensor<2, 3> one = unit_symmetric_tensor<3>();

template <int dim>
void test_tangent(const SolidLaw &law, const std::string &name)
{
  Random random;
  double error = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    const Tensor<2, 3> old_F               = one + random_tensor<dim>(random, 0.2),
                       F                   = rotation(0.7) * old_F + random_tensor<dim>(random, 0.2);
    const SymmetricTensor<2, 3> old_stress = symmetrize(random_tensor<dim>(random, 1e6));
    const auto response                    = law.evaluate(old_F, F, old_stress, dim);
    const double step                      = 1e-6;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int l = 0; l < dim; ++l)
      {
        Tensor<2, 3> g;
        g[k][l]          = step;
        const auto plus  = law.evaluate(old_F, (one + g) * F, old_stress, 0).stress,
                   minus = law.evaluate(old_F, (one - g) * F, old_stress, 0).stress;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            error = std::max(error, std::abs(response.tangent[i][j][k][l] -
                                             (plus[i][j] - minus[i][j]) / (2. * step)));
      }
  }
  check(name + ", " + std::to_string(dim) + "D: tangent against differences", error / law.shear_modulus(),
        1e-7);
}

void test_law(const std::string &name)
{
  const double E = 1e6, nu = 0.3;
  const auto law = make(name, {{"Young's modulus", "1e6"}, {"Poisson's ratio", "0.3"}, {"Density", "2500"}});
  check(name + ": moduli",
        std::abs(law->bulk_modulus() * 3. * (1. - 2. * nu) / E - 1.) +
          std::abs(law->shear_modulus() * 2. * (1. + nu) / E - 1.) + std::abs(law->density() - 2500.),
        1e-12);
  test_tangent<2>(*law, name);
  test_tangent<3>(*law, name);

  // A strained body turns once in 36 steps of 10 degrees, and in 4 of 90.
  for (const unsigned int n_steps : {36, 4})
  {
    Random random;
    const Tensor<2, 3> F_0                   = one + random_tensor<3>(random, 0.05);
    SymmetricTensor<2, 3> stress             = law->evaluate(one, F_0, SymmetricTensor<2, 3>(), 0).stress;
    const SymmetricTensor<2, 3> first_stress = stress;
    double error                             = 0.;
    for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const double angle   = 2. * numbers::PI / n_steps;
      const Tensor<2, 3> R = rotation(step * angle);
      stress               = law->evaluate(rotation((step - 1) * angle) * F_0, R * F_0, stress, 0).stress;
      const Tensor<2, 3> turned = R * static_cast<Tensor<2, 3>>(first_stress) * transpose(R);
      error = std::max(error, (static_cast<Tensor<2, 3>>(stress) - turned).norm() / first_stress.norm());
      error = std::max(error, std::abs(stress * stress / (first_stress * first_stress) - 1.));
    }
    check(name + ": a full turn in " + std::to_string(n_steps) + " steps turns the stress with it", error,
          1e-10);
  }

  // Small strains: Hooke's law, and the energy σ:ε/2.
  Random random;
  const double size                  = 1e-6;
  const Tensor<2, 3> H               = random_tensor<3>(random, size);
  const SymmetricTensor<2, 3> strain = symmetrize(H);
  const SymmetricTensor<2, 3> hooke  = 2. * law->shear_modulus() * deviator(strain) +
                                      law->bulk_modulus() * trace(strain) * unit_symmetric_tensor<3>();
  const auto stress = law->evaluate(one, one + H, SymmetricTensor<2, 3>(), 0).stress;
  check(name + ": Hooke's law for small strains", (stress - hooke).norm() / hooke.norm(), 10. * size);
  check(name + ": energy of small strains",
        law->energy_density(one + H, stress) / (0.5 * (hooke * strain)) - 1., 1e-4);
}

int main()
{
  test_law("hypoelastic");
  test_law("neo-Hookean");

  // Simple tension of the neo-Hookean solid: the stress is the derivative of the energy, dΨ = P dλ, P = σ J/λ.
  const auto law = make("neo-Hookean", {{"Young's modulus", "1e6"}, {"Poisson's ratio", "0.2"}});
  double error   = 0.;
  for (const double stretch : {0.6, 0.9, 1.2, 2.})
  {
    const auto at = [&](const double lambda) {
      Tensor<2, 3> F = one;
      F[0][0]        = lambda;
      return F;
    };
    const double step = 1e-5;
    const auto energy = [&](const double lambda) {
      return lambda * law->energy_density(at(lambda), SymmetricTensor<2, 3>());
    };
    const double P = law->evaluate(one, at(stretch), SymmetricTensor<2, 3>(), 0).stress[0][0];
    error = std::max(error, std::abs(P - (energy(stretch + step) - energy(stretch - step)) / (2. * step)));
  }
  check("neo-Hookean: stress is the derivative of the energy", error / 1e6, 1e-8);

  check_throws<InputError>("Poisson's ratio of 0.5", {"hypoelastic/Poisson's ratio", "0.5", "below 0.5"}, [] {
    make("hypoelastic", {{"Poisson's ratio", "0.5"}});
  });
  check_throws<InputError>("negative Young's modulus", {"neo-Hookean/Young's modulus", "-1"}, [] {
    make("neo-Hookean", {{"Young's modulus", "-1"}});
  });
  check_throws<InputError>("unknown law", {"Law", "rubber", "hypoelastic|neo-Hookean"}, [] {
    Parameters prm;
    SolidLaw::declare_parameters(prm);
    prm.set("Law", "rubber");
    SolidLaw::create(prm);
  });
  return n_failed;
}
