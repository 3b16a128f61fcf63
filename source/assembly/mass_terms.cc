// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/terms.h>
#include <lahar/geometry/simplex_geometry.h>

namespace Lahar
{
  namespace
  {
    /// V ∇N_I of each corner, linear (3D: quadratic) in the edges, whatever the volume is.
    template <int dim>
    std::array<Tensor<1, dim>, dim + 1> area_vectors(const SimplexCorners<dim> &x)
    {
      const Tensor<2, dim> edges = edge_matrix<dim>(x);
      std::array<Tensor<1, dim>, dim + 1> areas;
      if constexpr (dim == 2)
      {
        areas[1] = 0.5 * cross_product_2d(edges[1]);
        areas[2] = -0.5 * cross_product_2d(edges[0]);
      }
      else
        for (unsigned int c = 0; c < dim; ++c)
          areas[c + 1] = cross_product_3d(edges[(c + 1) % dim], edges[(c + 2) % dim]) / 6.;
      for (unsigned int c = 1; c <= dim; ++c)
        areas[0] -= areas[c];
      return areas;
    }

    /// Add the derivative of R_I = factor Σ_J ∫ N_I N_J x_J over a ring with respect to the radii.
    template <int dim>
    void assemble_mass_by_radius(const FluidCell<dim> &cell, const double factor,
                                 const std::array<double, dim + 1> &x, CellSystem<dim> &system)
    {
      using S = CellSystem<dim>;
      if (cell.is_ring())
        for (unsigned int I = 0; I <= dim; ++I)
          for (unsigned int K = 0; K <= dim; ++K)
            system.matrix[S::pressure_index(I)][S::index(K, radial)] += cell.motion() * factor *
                                                                        cell.mass_by_radius(I, K, x);
    }

    /// R_I += ∫ N_I (1/κ) (p − p_n)/Δt.
    template <int dim>
    void assemble_compression(const FluidCell<dim> &cell, CellSystem<dim> &system)
    {
      using S                      = CellSystem<dim>;
      constexpr unsigned n         = dim + 1;
      const auto &G                = cell.gradients();
      const double V               = cell.volume();
      const double compressibility = cell.law().compressibility() / cell.time_step();
      if (compressibility > 0.)
      {
        std::array<double, n> change;
        for (unsigned int I = 0; I < n; ++I)
          change[I] = cell.pressure()[I] - cell.old_pressure()[I];
        assemble_mass_by_radius(cell, compressibility, change, system);
        for (unsigned int I = 0; I < n; ++I)
        {
          double rate = 0.;
          for (unsigned int J = 0; J < n; ++J)
          {
            rate += compressibility * cell.mass(I, J) * (cell.pressure()[J] - cell.old_pressure()[J]);
            system.matrix[S::pressure_index(I)][S::pressure_index(J)] += compressibility * V *
                                                                         cell.mass(I, J);
          }
          system.residual[S::pressure_index(I)] += V * rate;
          for (unsigned int J = 0; J < n; ++J)
            for (unsigned int b = 0; b < dim; ++b)
              system.matrix[S::pressure_index(I)][S::index(J, b)] += cell.motion() * V * G[J][b] * rate;
        }
      }
    }

    /// Pressure and incompressibility of a ring. V_K = ∫ N_K moves with the cell's corners, so that its rate is
    /// ∫ N_K div v, and D_KJ = ∂V_K/∂x_J: R_J += Σ_K p_K D_KJ, R_K −= (V_K − V_K,n)/Δt.
    template <int dim>
    void assemble_ring_divergence(const FluidCell<dim> &cell, CellSystem<dim> &system)
    {
      using S                         = CellSystem<dim>;
      constexpr unsigned n            = dim + 1;
      const auto &G                   = cell.gradients();
      double p_V                      = 0.; // Σ p_K V_K
      std::array<double, n> by_radius = {}; // its derivatives where A does not change
      for (unsigned int K = 0; K < n; ++K)
      {
        p_V += cell.pressure()[K] * cell.share(K);
        system.residual[S::pressure_index(K)] -= (cell.share(K) - cell.old_shares()[K]) / cell.time_step();
        for (unsigned int J = 0; J < n; ++J)
        {
          by_radius[J] += cell.pressure()[K] * cell.share_by_radius(K, J);
          for (unsigned int b = 0; b < dim; ++b)
          {
            const double D = cell.share(K) * G[J][b] + (b == radial ? cell.share_by_radius(K, J) : 0.);
            system.matrix[S::index(J, b)][S::pressure_index(K)] += D;
            system.matrix[S::pressure_index(K)][S::index(J, b)] -= D;
          }
        }
      }
      for (unsigned int I = 0; I < n; ++I)
        for (unsigned int a = 0; a < dim; ++a)
        {
          system.residual[S::index(I, a)] += p_V * G[I][a] + (a == radial ? by_radius[I] : 0.);
          for (unsigned int J = 0; J < n; ++J)
            for (unsigned int b = 0; b < dim; ++b)
              system.matrix[S::index(I, a)][S::index(J, b)] +=
                cell.motion() *
                (p_V * (G[J][b] * G[I][a] - G[J][a] * G[I][b]) + (b == radial ? by_radius[J] * G[I][a] : 0.) +
                 (a == radial ? by_radius[I] * G[J][b] : 0.));
        }
    }
  } // namespace



  template <int dim>
  void PressureDivergence<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    if (cell.is_ring())
    {
      assemble_ring_divergence(cell, system);
      assemble_compression(cell, system);
      return;
    }
    using S              = CellSystem<dim>;
    constexpr unsigned n = dim + 1;
    const auto &G        = cell.gradients();
    const double V       = cell.volume();
    const double p       = cell.mean_pressure();
    const double growth  = (V - cell.old_volume()) / cell.time_step();

    for (unsigned int I = 0; I < n; ++I)
    {
      system.residual[S::pressure_index(I)] -= growth / n;
      for (unsigned int a = 0; a < dim; ++a)
        system.residual[S::index(I, a)] += V * p * G[I][a];

      for (unsigned int J = 0; J < n; ++J)
        for (unsigned int b = 0; b < dim; ++b)
        {
          const double s_V = cell.motion() * V;
          system.matrix[S::index(I, b)][S::pressure_index(J)] += V / n * G[I][b];
          system.matrix[S::pressure_index(I)][S::index(J, b)] -= V / n * G[J][b];
          for (unsigned int a = 0; a < dim; ++a)
            system.matrix[S::index(I, a)][S::index(J, b)] += s_V * p *
                                                             (G[J][b] * G[I][a] - G[J][a] * G[I][b]);
        }
    }

    assemble_compression(cell, system);
  }



  template <int dim>
  void FlatPressureDivergence<dim>::assemble(const FluidCell<dim> &cell, const SimplexCorners<dim> &corners,
                                             CellSystem<dim> &system) const
  {
    using S              = CellSystem<dim>;
    constexpr unsigned n = dim + 1;
    const auto areas     = area_vectors<dim>(corners);
    const double p       = cell.mean_pressure();
    const double growth  = (signed_volume<dim>(corners) - cell.old_volume()) / cell.time_step();
    for (unsigned int I = 0; I < n; ++I)
    {
      system.residual[S::pressure_index(I)] -= growth / n;
      for (unsigned int a = 0; a < dim; ++a)
        system.residual[S::index(I, a)] += p * areas[I][a];
      for (unsigned int J = 0; J < n; ++J)
        for (unsigned int b = 0; b < dim; ++b)
        {
          system.matrix[S::index(I, b)][S::pressure_index(J)] += areas[I][b] / n;
          system.matrix[S::pressure_index(I)][S::index(J, b)] -= areas[J][b] / n;
        }
    }
    assemble_compression(cell, system);
  }



  namespace
  {
    /// R_I += ∫ τ_s ∇N_I·(q − π), q = ∇p + ρ g − ρ ā; ā with @p density zero where it is left out.
    template <int dim>
    void assemble_gradient_term(const FluidCell<dim> &cell, const double inertia_density,
                                CellSystem<dim> &system)
    {
      using S                     = CellSystem<dim>;
      constexpr unsigned n        = dim + 1;
      const auto &G               = cell.gradients();
      const double tau_V          = cell.stabilization() * cell.volume();
      const Tensor<1, dim> grad_p = cell.pressure_gradient();
      const Tensor<1, dim> q      = cell.momentum_residual(inertia_density) - cell.residual_projection();

      for (unsigned int I = 0; I < n; ++I)
      {
        const double G_q = G[I] * q;
        system.residual[S::pressure_index(I)] += tau_V * G_q;
        for (unsigned int J = 0; J < n; ++J)
        {
          const double GG = G[I] * G[J], GJ_q = G[J] * q;
          const double mass_factor = inertia_density * cell.acceleration_factor()[J] / n;
          system.matrix[S::pressure_index(I)][S::pressure_index(J)] += tau_V * GG;
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::pressure_index(I)][S::index(J, b)] +=
              tau_V * (-mass_factor * G[I][b] +
                       cell.motion() * (cell.expansion()[J][b] * G_q - G[I][b] * GJ_q - GG * grad_p[b]));
        }
      }
    }
  } // namespace



  template <int dim>
  void FICInterior<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S = CellSystem<dim>;
    assemble_gradient_term(cell, 0., system);

    const double dt = cell.time_step();
    const double c  = cell.stabilization() * cell.law().density() * cell.law().compressibility() / (dt * dt);
    if (c > 0.)
    {
      std::array<double, dim + 1> change;
      for (unsigned int I = 0; I <= dim; ++I)
        change[I] = cell.pressure()[I] - cell.old_pressure()[I] - cell.old_pressure_rate()[I] * dt;
      assemble_mass_by_radius(cell, c, change, system);
      for (unsigned int I = 0; I <= dim; ++I)
      {
        double rate = 0.;
        for (unsigned int J = 0; J <= dim; ++J)
        {
          rate += c * cell.mass(I, J) *
                  (cell.pressure()[J] - cell.old_pressure()[J] - cell.old_pressure_rate()[J] * dt);
          system.matrix[S::pressure_index(I)][S::pressure_index(J)] += c * cell.volume() * cell.mass(I, J);
        }
        system.residual[S::pressure_index(I)] += cell.volume() * rate;
        for (unsigned int J = 0; J <= dim; ++J)
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::pressure_index(I)][S::index(J, b)] += cell.motion() * cell.volume() *
                                                                   cell.gradients()[J][b] * rate;
      }
    }
  }



  template <int dim>
  void FICFreeSurface<dim>::assemble(const FluidCell<dim> &cell, const unsigned int k,
                                     CellSystem<dim> &system) const
  {
    Assert(!cell.is_ring(), ExcMessage("'FIC' is refused with rotational symmetry."));
    // n = −G_k/|G_k|, 1/h_n = |G_k| and the face's area is dim V |G_k|, so that everything is polynomial in G and V.
    using S                   = CellSystem<dim>;
    constexpr unsigned n      = dim + 1;
    const auto &G             = cell.gradients();
    const Tensor<1, dim> Gk   = G[k];
    const double Gk_square    = Gk.norm_square();
    const double rho          = cell.law().density();
    const double viscosity    = cell.stabilization_viscosity();
    const double tau_V        = cell.stabilization() * cell.volume();
    const Tensor<1, dim> d_Gk = cell.deviator() * Gk;
    const double Gk_d_Gk      = Gk * d_Gk;
    const double c_p          = 2. * dim * tau_V;
    const double c_a          = rho * dim * tau_V;
    const double c_d          = 4. * viscosity * tau_V;

    for (unsigned int I = 0; I < n; ++I)
    {
      if (I == k)
        continue;
      double p = 0.;
      Tensor<1, dim> a;
      for (unsigned int J = 0; J < n; ++J)
        if (J != k)
        {
          p += cell.face_mass(I, J) * cell.pressure()[J];
          a += cell.face_mass(I, J) * cell.acceleration()[J];
        }
      const double residual = c_p * Gk_square * p + c_a * (a * Gk) + c_d * Gk_d_Gk;
      system.residual[S::pressure_index(I)] += residual;

      for (unsigned int J = 0; J < n; ++J)
      {
        if (J != k)
          system.matrix[S::pressure_index(I)][S::pressure_index(J)] += c_p * Gk_square * cell.face_mass(I, J);
        const double Gk_GJ = Gk * G[J];
        for (unsigned int b = 0; b < dim; ++b)
        {
          // δ(d'): sym(w_b ⊗ G_J) less a third of its trace; δG_k = −s G_kb G_J.
          const double deviatoric = (cell.w()[J][b] * Gk) * Gk_GJ - (cell.w()[J][b] * G[J]) * Gk_square / 3.;
          double entry            = c_d * deviatoric;
          if (J != k)
            entry += c_a * cell.face_mass(I, J) * cell.acceleration_factor()[J] * Gk[b];
          entry += cell.motion() * (G[J][b] * residual - Gk[b] * (2. * c_p * p * Gk_GJ + c_a * (a * G[J]) +
                                                                  2. * c_d * (d_Gk * G[J])));
          system.matrix[S::pressure_index(I)][S::index(J, b)] += entry;
        }
      }
    }
  }



  template <int dim>
  void ResidualStabilization<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    assemble_gradient_term(cell, cell.law().density(), system);
  }



  template struct PressureDivergence<2>;
  template struct PressureDivergence<3>;
  template struct FlatPressureDivergence<2>;
  template struct FlatPressureDivergence<3>;
  template struct FICInterior<2>;
  template struct FICInterior<3>;
  template struct FICFreeSurface<2>;
  template struct FICFreeSurface<3>;
  template struct ResidualStabilization<2>;
  template struct ResidualStabilization<3>;
} // namespace Lahar
