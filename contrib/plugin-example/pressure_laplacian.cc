// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/stabilization.h>
#include <lahar/utilities/factory.h>

namespace Lahar
{
  /**
   * Pressure Laplacian (Brezzi & Pitkäranta 1984): R_I += ∫ τ_s ∇N_I·∇p. Not consistent: a fluid at rest is disturbed.
   */
  template <int dim>
  class PressureLaplacian : public Stabilization<dim>
  {
  public:
    void assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const override
    {
      using S                     = CellSystem<dim>;
      const auto &G               = cell.gradients();
      const double tau_V          = cell.stabilization() * cell.volume();
      const Tensor<1, dim> grad_p = cell.pressure_gradient();

      for (unsigned int I = 0; I <= dim; ++I)
      {
        const double G_grad_p = G[I] * grad_p;
        system.residual[S::pressure_index(I)] += tau_V * G_grad_p;
        for (unsigned int J = 0; J <= dim; ++J)
        {
          system.matrix[S::pressure_index(I)][S::pressure_index(J)] += tau_V * (G[I] * G[J]);
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::pressure_index(I)][S::index(J, b)] +=
              tau_V * cell.motion() *
              (G[J][b] * G_grad_p - G[I][b] * (G[J] * grad_p) - (G[I] * G[J]) * grad_p[b]);
        }
      }
    }
  };



  static const Factory<Stabilization<2>>::Registration<PressureLaplacian<2>>
    pressure_laplacian_2d("pressure Laplacian", "Brezzi & Pitkäranta 1984; disturbs a fluid at rest.");
  static const Factory<Stabilization<3>>::Registration<PressureLaplacian<3>>
    pressure_laplacian_3d("pressure Laplacian", "Brezzi & Pitkäranta 1984; disturbs a fluid at rest.");
} // namespace Lahar
