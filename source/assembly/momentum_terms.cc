// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/terms.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  template <int dim>
  void Inertia<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S              = CellSystem<dim>;
    const double mass    = cell.law->density() * cell.volume;
    constexpr unsigned n = dim + 1;
    for (unsigned int I = 0; I < n; ++I)
    {
      Tensor<1, dim> force;
      for (unsigned int J = 0; J < n; ++J)
        force += mass * cell.mass(I, J) * cell.acceleration[J];
      for (unsigned int a = 0; a < dim; ++a)
      {
        system.residual[S::index(I, a)] += force[a];
        for (unsigned int J = 0; J < n; ++J)
        {
          system.matrix[S::index(I, a)][S::index(J, a)] += mass * cell.mass(I, J) *
                                                           cell.acceleration_factor[J];
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::index(I, a)][S::index(J, b)] += cell.motion * cell.gradients[J][b] * force[a];
        }
      }
    }
  }



  template <int dim>
  void BodyForce<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S                    = CellSystem<dim>;
    const Tensor<1, dim> force = -cell.law->density() * cell.volume / (dim + 1) * cell.gravity;
    for (unsigned int I = 0; I <= dim; ++I)
      for (unsigned int a = 0; a < dim; ++a)
      {
        system.residual[S::index(I, a)] += force[a];
        for (unsigned int J = 0; J <= dim; ++J)
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::index(I, a)][S::index(J, b)] += cell.motion * cell.gradients[J][b] * force[a];
      }
  }



  namespace
  {
    // Along d' the primal-dual Jacobian of a yielding cell almost vanishes. Where Λ and the strain rate do not agree yet,
    // so that this says little about the solution, part of the secant stiffness is left in it: in the cell, since a
    // thread of a few cells that yields in tension cannot be seen in any norm over all cells.
    constexpr double largest_stiffening = 0.3;
    constexpr double stiffening_rate    = 3.;

    /// The material part of the Jacobian, 2 μ_t I' + c (A ⊗ B + B ⊗ A).
    template <int dim>
    struct ViscousTangent
    {
      double viscosity   = 0.;
      double coefficient = 0.;
      SymmetricTensor<2, dim> A, B;
    };

    template <int dim>
    ViscousTangent<dim> viscous_tangent(const FluidCell<dim> &cell, const double viscosity,
                                        const ViscosityLinearization linearization,
                                        const double plastic_weight)
    {
      ViscousTangent<dim> tangent;
      tangent.viscosity = viscosity;
      const double rate = cell.strain_rate;
      if (linearization == ViscosityLinearization::picard || rate < std::numeric_limits<double>::min())
        return tangent;

      const double tau_0              = cell.law->has_exact_yield_stress() ? 0. : cell.law->yield_stress();
      const FluidLaw::Value plastic   = cell.law->plastic_part(rate);
      const double viscous_derivative = cell.law->viscous_part(rate).derivative;
      tangent.A                       = cell.deviator;

      tangent.coefficient = 1.;
      // The viscous part's derivative is Newton's in both schemes; −ψ'/ψ = f'/f.
      tangent.B = 2. * viscous_derivative / rate * cell.deviator;
      if (linearization == ViscosityLinearization::newton)
        tangent.B += plastic_weight * 2. * tau_0 * plastic.derivative / rate * cell.deviator;
      else if (tau_0 > 0.)
      {
        const auto norm_of  = [](const SymmetricTensor<2, dim> &t) { return std::sqrt(0.5 * (t * t)); };
        const double gap    = norm_of(cell.plastic_dual - 2. * plastic.value * cell.deviator);
        const double norm   = norm_of(cell.plastic_dual);
        const double weight = std::min(plastic_weight,
                                       1. - std::min(largest_stiffening, stiffening_rate * gap));
        tangent.B += weight * tau_0 * plastic.derivative / plastic.value / rate / std::max(1., norm) *
                     cell.plastic_dual;
      }
      return tangent;
    }
  } // namespace



  template <int dim>
  void ViscousStress<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S                              = CellSystem<dim>;
    constexpr unsigned n                 = dim + 1;
    const double viscosity               = cell.law->has_exact_yield_stress()
                                             ? cell.law->viscous_part(cell.strain_rate).value
                                             : cell.law->effective_viscosity(cell.strain_rate).value;
    const SymmetricTensor<2, dim> stress = 2. * viscosity * cell.deviator;
    const ViscousTangent<dim> tangent    = viscous_tangent(cell, viscosity, linearization, plastic_weight);
    const auto &G                        = cell.gradients;
    const double mu_V                    = tangent.viscosity * cell.volume;
    const double c_V                     = tangent.coefficient * cell.volume;

    std::array<Tensor<1, dim>, n> traction, A, B;
    for (unsigned int I = 0; I < n; ++I)
    {
      traction[I] = stress * G[I];
      A[I]        = tangent.A * G[I];
      B[I]        = tangent.B * G[I];
      for (unsigned int a = 0; a < dim; ++a)
        system.residual[S::index(I, a)] += cell.volume * traction[I][a];
    }

    for (unsigned int J = 0; J < n; ++J)
      for (unsigned int b = 0; b < dim; ++b)
      {
        const Tensor<1, dim> &w = cell.w[J][b];
        const double w_G = w * G[J], w_A = w * A[J], w_B = w * B[J], s_V = cell.motion * cell.volume;
        for (unsigned int I = 0; I < n; ++I)
        {
          const double w_GI = w * G[I], GG = G[I] * G[J];
          for (unsigned int a = 0; a < dim; ++a)
            system.matrix[S::index(I, a)][S::index(J, b)] +=
              mu_V * (w[a] * GG + w_GI * G[J][a] - 2. / 3. * w_G * G[I][a]) +
              c_V * (A[I][a] * w_B + B[I][a] * w_A) +
              s_V * (G[J][b] * traction[I][a] - traction[J][a] * G[I][b]);
        }
      }
  }



  template struct Inertia<2>;
  template struct Inertia<3>;
  template struct BodyForce<2>;
  template struct BodyForce<3>;
  template class ViscousStress<2>;
  template class ViscousStress<3>;
} // namespace Lahar
