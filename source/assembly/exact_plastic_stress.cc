// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/exact_plastic_stress.h>

namespace Lahar
{
  namespace
  {
    // As in ViscousStress: part of the secant stiffness is left where Λ and X do not agree yet.
    constexpr double largest_stiffening = 0.3;
    constexpr double stiffening_rate    = 3.;
  } // namespace



  template <int dim>
  SymmetricTensor<2, dim> ExactPlasticStress<dim>::rank_one_part(const FluidCell<dim> &cell,
                                                                 const SymmetricTensor<2, dim> &rate,
                                                                 const double strain_rate) const
  {
    const FluidLaw::Value f = cell.law->plastic_part(strain_rate);
    if (linearization == ViscosityLinearization::picard || f.derivative == 0.)
      return {};
    const double factor = cell.law->yield_stress() * f.derivative / strain_rate;
    if (linearization == ViscosityLinearization::newton)
      return 2. * plastic_weight * factor * rate;
    const double gap    = deviator_norm<dim>(cell.plastic_dual - 2. * f.value * rate);
    const double weight = std::min(plastic_weight, 1. - std::min(largest_stiffening, stiffening_rate * gap));
    return weight * factor / f.value * project_deviator<dim>(cell.plastic_dual);
  }



  template <int dim>
  void ExactPlasticStress<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S                            = CellSystem<dim>;
    constexpr unsigned n               = dim + 1;
    const SymmetricTensor<2, dim> rate = cell.plastic_rate();
    const double strain_rate           = cell.plastic_strain_rate();
    const double viscosity             = cell.law->yield_stress() * cell.law->plastic_part(strain_rate).value;
    const SymmetricTensor<2, dim> rank_one = rank_one_part(cell, rate, strain_rate);
    const auto &G                          = cell.gradients;
    const double V = cell.volume, s_V = cell.motion * cell.volume;

    std::array<Tensor<1, dim>, n> traction, A, B;
    for (unsigned int I = 0; I < n; ++I)
    {
      A[I]        = rate * G[I];
      B[I]        = rank_one * G[I];
      traction[I] = 2. * viscosity * A[I];
      for (unsigned int a = 0; a < dim; ++a)
        system.residual[S::index(I, a)] += V * traction[I][a];
    }

    for (unsigned int J = 0; J < n; ++J)
      for (unsigned int b = 0; b < dim; ++b)
      {
        const Tensor<1, dim> &w = cell.w[J][b];
        const double w_G = w * G[J], w_A = w * A[J], w_B = w * B[J];
        for (unsigned int I = 0; I < n; ++I)
        {
          const double w_GI = w * G[I], GG = G[I] * G[J];
          for (unsigned int a = 0; a < dim; ++a)
            system.matrix[S::index(I, a)][S::index(J, b)] +=
              V * (viscosity * (w[a] * GG + w_GI * G[J][a] - 2. / 3. * w_G * G[I][a]) + A[I][a] * w_B +
                   B[I][a] * w_A) +
              s_V * (G[J][b] * traction[I][a] - traction[J][a] * G[I][b]);
        }
      }
  }



  template class ExactPlasticStress<2>;
  template class ExactPlasticStress<3>;
} // namespace Lahar
