// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/terms.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
    constexpr unsigned int radial = 0;
  }



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
      if (cell.is_ring)
        for (unsigned int K = 0; K < n; ++K)
        {
          const Tensor<1, dim> by_radius = cell.motion * cell.law->density() *
                                           cell.mass_by_radius(I, K, cell.acceleration);
          for (unsigned int a = 0; a < dim; ++a)
            system.matrix[S::index(I, a)][S::index(K, radial)] += by_radius[a];
        }
    }
  }



  template <int dim>
  void BodyForce<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S              = CellSystem<dim>;
    Tensor<1, dim> force = -cell.law->density() * cell.volume / (dim + 1) * cell.gravity;
    for (unsigned int I = 0; I <= dim; ++I)
    {
      if (cell.is_ring)
        force = -cell.law->density() * cell.share(I) * cell.gravity;
      for (unsigned int a = 0; a < dim; ++a)
      {
        system.residual[S::index(I, a)] += force[a];
        for (unsigned int J = 0; J <= dim; ++J)
        {
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::index(I, a)][S::index(J, b)] += cell.motion * cell.gradients[J][b] * force[a];
          if (cell.is_ring)
            system.matrix[S::index(I, a)][S::index(J, radial)] -= cell.motion * cell.law->density() *
                                                                  cell.share_by_radius(I, J) *
                                                                  cell.gravity[a];
        }
      }
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

      const double pressure           = cell.confining_pressure();
      const double tau_y              = cell.law->yield_stress(pressure).value;
      const FluidLaw::Value plastic   = cell.law->plastic_part(rate);
      const double viscous_derivative = cell.law->viscous_part(rate, pressure).derivative;
      tangent.A                       = cell.deviator;

      tangent.coefficient = 1.;
      // The viscous part's derivative is Newton's in both schemes; −ψ'/ψ = f'/f.
      tangent.B = 2. * viscous_derivative / rate * cell.deviator;
      if (linearization == ViscosityLinearization::newton)
        tangent.B += plastic_weight * 2. * tau_y * plastic.derivative / rate * cell.deviator;
      else if (tau_y > 0.)
      {
        const auto norm_of = [&cell](const SymmetricTensor<2, dim> &t) {
          return std::sqrt(0.5 * cell.product(t, t));
        };
        const double gap    = norm_of(cell.plastic_dual - 2. * plastic.value * cell.deviator);
        const double norm   = norm_of(cell.plastic_dual);
        const double weight = std::min(plastic_weight,
                                       1. - std::min(largest_stiffening, stiffening_rate * gap));
        tangent.B += weight * tau_y * plastic.derivative / plastic.value / rate / std::max(1., norm) *
                     cell.plastic_dual;
      }
      return tangent;
    }
  } // namespace



  namespace
  {
    /// What the hoop of a ring adds: R_Ir += V η τ_θθ, where out-of-plane components are less the trace of the others, and
    /// in the Jacobian all that has η. @param traction τ G_I, A G_I and B G_I.
    void assemble_hoop_stress(const FluidCell<2> &cell, const ViscousTangent<2> &tangent,
                              const SymmetricTensor<2, 2> &stress,
                              const std::array<std::array<Tensor<1, 2>, 3>, 3> &traction,
                              CellSystem<2> &system)
    {
      using S                      = CellSystem<2>;
      const auto &G                = cell.gradients;
      const auto &[stress_G, A, B] = traction;
      const double eta = cell.hoop_gradient, hoop_stress = -trace(stress);
      const double hoop_A = -trace(tangent.A), hoop_B = -trace(tangent.B);
      const double mu_V = tangent.viscosity * cell.volume, c_V = tangent.coefficient * cell.volume,
                   s_V = cell.motion * cell.volume;
      for (unsigned int I = 0; I < 3; ++I)
      {
        system.residual[S::index(I, radial)] += cell.volume * eta * hoop_stress;
        for (unsigned int J = 0; J < 3; ++J)
        {
          const double hoop = eta * cell.hoop_w[J]; // δL_θθ
          for (unsigned int b = 0; b < 2; ++b)
          {
            const Tensor<1, 2> &w = cell.w[J][b];
            system.matrix[S::index(I, radial)][S::index(J, b)] +=
              eta * (-2. / 3. * mu_V * (w * G[J]) + c_V * (hoop_A * (w * B[J]) + hoop_B * (w * A[J])) +
                     s_V * hoop_stress * G[J][b]);
          }
          for (unsigned int a = 0; a < 2; ++a)
            system.matrix[S::index(I, a)][S::index(J, radial)] +=
              hoop * (-2. / 3. * mu_V * G[I][a] + c_V * (A[I][a] * hoop_B + B[I][a] * hoop_A)) +
              s_V * eta * stress_G[I][a];
          system.matrix[S::index(I, radial)][S::index(J, radial)] +=
            eta * hoop * (4. / 3. * mu_V + 2. * c_V * hoop_A * hoop_B);
        }
      }
    }
  } // namespace



  template <int dim>
  void ViscousStress<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S                              = CellSystem<dim>;
    constexpr unsigned n                 = dim + 1;
    const FluidLaw::Value viscosity      = cell.law->effective_viscosity(cell.strain_rate,
                                                                         cell.confining_pressure());
    const SymmetricTensor<2, dim> stress = 2. * viscosity.value * cell.deviator;
    const ViscousTangent<dim> tangent = viscous_tangent(cell, viscosity.value, linearization, plastic_weight);
    const auto &G                     = cell.gradients;
    const double mu_V                 = tangent.viscosity * cell.volume;
    const double c_V                  = tangent.coefficient * cell.volume;

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
    if constexpr (dim == 2)
      if (cell.is_ring)
        assemble_hoop_stress(cell, tangent, stress, {{traction, A, B}}, system);

    if (viscosity.pressure_derivative == 0. || linearization == ViscosityLinearization::picard ||
        !(cell.mean_pressure() < 0.))
      return;
    const SymmetricTensor<2, dim> by_pressure = -2. * cell.volume / n * viscosity.pressure_derivative *
                                                cell.deviator;
    for (unsigned int I = 0; I < n; ++I)
    {
      Tensor<1, dim> column = by_pressure * G[I];
      if (cell.is_ring)
        column[radial] -= cell.hoop_gradient * trace(by_pressure);
      for (unsigned int J = 0; J < n; ++J)
        for (unsigned int a = 0; a < dim; ++a)
          system.matrix[S::index(I, a)][S::pressure_index(J)] += column[a];
    }
  }



  template struct Inertia<2>;
  template struct Inertia<3>;
  template struct BodyForce<2>;
  template struct BodyForce<3>;
  template class ViscousStress<2>;
  template class ViscousStress<3>;
} // namespace Lahar
