// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/assemble_stress.h>

namespace Lahar
{
  namespace
  {
    /// What the hoop of a ring adds: R_Ir += V η τ_θθ, where out-of-plane components are less the trace of the others, and
    /// in the Jacobian all that has η. @param traction τ G_I, A G_I and B G_I.
    void assemble_hoop_stress(const FluidCell<2> &cell, const StressTangent<2> &tangent,
                              const SymmetricTensor<2, 2> &stress,
                              const std::array<std::array<Tensor<1, 2>, 3>, 3> &traction,
                              CellSystem<2> &system)
    {
      using S                      = CellSystem<2>;
      const auto &G                = cell.gradients();
      const auto &[stress_G, A, B] = traction;
      const double eta = cell.hoop_gradient(), hoop_stress = -trace(stress);
      const double hoop_A = -trace(tangent.A), hoop_B = -trace(tangent.B);
      const double mu_V = tangent.viscosity * cell.volume(), c_V = tangent.coefficient * cell.volume(),
                   s_V = cell.motion() * cell.volume();
      for (unsigned int I = 0; I < 3; ++I)
      {
        system.residual[S::index(I, radial)] += cell.volume() * eta * hoop_stress;
        for (unsigned int J = 0; J < 3; ++J)
        {
          const double hoop = eta * cell.hoop_w()[J]; // δL_θθ
          for (unsigned int b = 0; b < 2; ++b)
          {
            const Tensor<1, 2> &w = cell.w()[J][b];
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
  void assemble_stress(const FluidCell<dim> &cell, const SymmetricTensor<2, dim> &stress,
                       const StressTangent<dim> &tangent, CellSystem<dim> &system)
  {
    using S              = CellSystem<dim>;
    constexpr unsigned n = dim + 1;
    const auto &G        = cell.gradients();
    const double mu_V    = tangent.viscosity * cell.volume();
    const double c_V     = tangent.coefficient * cell.volume();

    std::array<Tensor<1, dim>, n> traction, A, B;
    for (unsigned int I = 0; I < n; ++I)
    {
      traction[I] = stress * G[I];
      A[I]        = tangent.A * G[I];
      B[I]        = tangent.B * G[I];
      for (unsigned int a = 0; a < dim; ++a)
        system.residual[S::index(I, a)] += cell.volume() * traction[I][a];
    }

    for (unsigned int J = 0; J < n; ++J)
      for (unsigned int b = 0; b < dim; ++b)
      {
        const Tensor<1, dim> &w = cell.w()[J][b];
        const double w_G = w * G[J], w_A = w * A[J], w_B = w * B[J], s_V = cell.motion() * cell.volume();
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
      if (cell.is_ring())
        assemble_hoop_stress(cell, tangent, stress, {{traction, A, B}}, system);
  }



  template <int dim>
  void assemble_stress(const FluidCell<dim> &cell, const CellStress<dim> &first,
                       const CellStress<dim> &second, CellSystem<dim> &system)
  {
    if (first.tangent.coefficient != 0.)
    {
      assemble_stress(cell, first.stress, first.tangent, system);
      assemble_stress(cell, second.stress, second.tangent, system);
      return;
    }
    StressTangent<dim> tangent = second.tangent;
    tangent.viscosity += first.tangent.viscosity;
    assemble_stress(cell, SymmetricTensor<2, dim>(first.stress + second.stress), tangent, system);
  }



  template void assemble_stress(const FluidCell<2> &, const SymmetricTensor<2, 2> &, const StressTangent<2> &,
                                CellSystem<2> &);
  template void assemble_stress(const FluidCell<3> &, const SymmetricTensor<2, 3> &, const StressTangent<3> &,
                                CellSystem<3> &);
  template void assemble_stress(const FluidCell<2> &, const CellStress<2> &, const CellStress<2> &,
                                CellSystem<2> &);
  template void assemble_stress(const FluidCell<3> &, const CellStress<3> &, const CellStress<3> &,
                                CellSystem<3> &);
} // namespace Lahar
