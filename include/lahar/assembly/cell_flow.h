// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_cell_flow_h
#define lahar_assembly_cell_flow_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <lahar/geometry/simplex_geometry.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/material/fluid_law.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /**
   * The flow in one linear simplex: its shape, the velocities v_I and pressures p_I of its corners, and what follows from
   * them, G_I = ∇N_I, L = Σ v_I ⊗ G_I, its deviator and γ̇.
   *
   * With rotational symmetry (Symmetry) the cell is a ring: V = 2π r̄ A, and strain has the hoop component
   * L_θθ = v_r/r, taken at the centroid, v̄_r/r̄. With η = 1/(3 r̄) it is Σ v_Ir η; V (tr L + L_θθ) is the rate of V. All are
   * regular on the axis, since r̄ > 0.
   *
   * All is computed by the constructor and stays. In a simplex without volume, flat or inverted, only what is given and its
   * signed volume mean something; the rest is zero.
   */
  template <int dim>
  class CellFlow
  {
  public:
    static constexpr unsigned int n_nodes = dim + 1;

    /// @param corners m. @param velocities, pressures of the @p vertices, m/s and Pa.
    CellFlow(const SimplexCorners<dim> &corners, const Simplex<dim> &vertices,
             const std::vector<Tensor<1, dim>> &velocities, const std::vector<double> &pressures);

    /// x_I, m.
    const SimplexCorners<dim> &corners() const
    {
      return x;
    }

    /// v_I, m/s.
    const std::array<Tensor<1, dim>, n_nodes> &velocity() const
    {
      return v;
    }

    /// p_I, Pa, positive in tension.
    const std::array<double, n_nodes> &pressure() const
    {
      return p;
    }

    /// G_I, 1/m.
    const std::array<Tensor<1, dim>, n_nodes> &gradients() const
    {
      return G;
    }

    /// V, m³ (m² in the plane).
    double volume() const
    {
      return V;
    }

    /// L_ij = ∂v_i/∂x_j, 1/s.
    const Tensor<2, dim> &velocity_gradient() const
    {
      return L;
    }

    /// In-plane part of d', 1/s.
    const SymmetricTensor<2, dim> &deviator() const
    {
      return d;
    }

    /// γ̇ = sqrt(2 d':d'), 1/s.
    double strain_rate() const
    {
      return gamma;
    }

    /// Whether the cell is a ring.
    bool is_ring() const
    {
      return ring;
    }

    /// A, in the plane; volume() without rotational symmetry.
    double section() const
    {
      return A;
    }

    /// L_θθ, 1/s.
    double hoop_rate() const
    {
      return L_hoop;
    }

    /// η, 1/m.
    double hoop_gradient() const
    {
      return eta;
    }

    double mean_pressure() const
    {
      double sum = 0.;
      for (const double p_I : p)
        sum += p_I / n_nodes;
      return sum;
    }

    /// P, Pa, what laws of fluids know of the pressure: −p̄ less the mean of p_w over the corners, or zero where that is
    /// below zero. p̄ is the mean pressure, p_w that of the law's PoreWater under @p gravity (m/s²).
    double confining_pressure(const FluidLaw &law, const Tensor<1, dim> &gravity) const
    {
      double sum = mean_pressure();
      if (law.pore_water().is_there())
        for (const Point<dim> &x_I : x)
          sum += law.pore_water().pressure(x_I, gravity) / n_nodes;
      return std::max(-sum, 0.);
    }

    Tensor<1, dim> pressure_gradient() const
    {
      Tensor<1, dim> sum;
      for (unsigned int I = 0; I < n_nodes; ++I)
        sum += p[I] * G[I];
      return sum;
    }

    /// The edge of the equilateral simplex with the same volume, m.
    double edge() const
    {
      return dim == 2 ? std::sqrt(4. / std::sqrt(3.) * A) : std::cbrt(6. * std::sqrt(2.) * A);
    }

    /// ∫ N_I N_J over the cell, divided by its volume.
    double mass(const unsigned int I, const unsigned int J) const
    {
      if constexpr (dim == 2)
        if (ring)
        {
          double sum = 0.;
          for (unsigned int K = 0; K < n_nodes; ++K)
            sum += product_of_three(I, J, K) * radius[K];
          return 3. * eta * sum;
        }
      return (I == J ? 2. : 1.) / ((dim + 1) * (dim + 2));
    }

    /// Derivative of Σ_J x_J ∫ N_I N_J over a ring with respect to the radius of node K.
    template <typename Number>
    Number mass_by_radius(const unsigned int I, const unsigned int K,
                          const std::array<Number, n_nodes> &x) const
    {
      Number sum = Number();
      for (unsigned int J = 0; J < n_nodes; ++J)
        sum += 2. * numbers::PI * A * product_of_three(I, J, K) * x[J];
      return sum;
    }

    /// The same of ∫ N_I.
    double share_by_radius(const unsigned int I, const unsigned int K) const
    {
      return 2. * numbers::PI * A / 12. * (I == K ? 2. : 1.);
    }

    /// ∫ N_I over a ring.
    double share(const unsigned int I) const
    {
      return ring_share(A, 1. / eta, radius[I]);
    }

    /// a:b of deviators, with their components out of the plane where these are those of a hoop.
    double product(const SymmetricTensor<2, dim> &a, const SymmetricTensor<2, dim> &b) const
    {
      return ring ? a * b + trace(a) * trace(b) : a * b;
    }

    /// ∫ N_I N_J over a face with both nodes, divided by its area.
    static constexpr double face_mass(const unsigned int I, const unsigned int J)
    {
      return (I == J ? 2. : 1.) / (dim * (dim + 1));
    }

  private:
    /// ∫ N_I N_J N_K over a triangle, divided by its area.
    static constexpr double product_of_three(const unsigned int I, const unsigned int J, const unsigned int K)
    {
      return (I == J && J == K ? 6. : (I == J || J == K || I == K ? 2. : 1.)) / 60.;
    }

    SimplexCorners<dim> x;
    std::array<Tensor<1, dim>, n_nodes> v;
    std::array<double, n_nodes> p;
    std::array<Tensor<1, dim>, n_nodes> G;
    double V = 0., A = 0.;
    Tensor<2, dim> L;
    SymmetricTensor<2, dim> d;
    double gamma  = 0.;
    bool ring     = Symmetry::applies<dim>();
    double L_hoop = 0., eta = 0.;
    std::array<double, n_nodes> radius = {}; ///< r_I of a ring, m
  };
} // namespace Lahar

#endif
