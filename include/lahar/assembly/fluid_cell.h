// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_fluid_cell_h
#define lahar_assembly_fluid_cell_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <lahar/assembly/deviator.h>
#include <lahar/geometry/symmetry.h>
#include <lahar/material/fluid_law.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Lahar
{
  using namespace dealii;

  /**
   * What the terms of the weak form need to know of one linear simplex at the end of the step.
   *
   * The unknown is the corners' mean velocity in the step (TimeIntegration). G_I = ∇N_I and V are those of the present
   * configuration, v_I velocities at its time, L = Σ v_I ⊗ G_I. When the mean velocity of node J changes in direction e_b,
   * v_J changes by c_J e_b and the node moves by s e_b, s = Δt, so that
   *
   *   δV = s V G_Jb,   δG_I = −s G_Ib G_J,   δL = w_Jb ⊗ G_J with w_Jb = c_J e_b − s L e_b.
   *
   * With s = 0 in #motion the terms leave the derivatives of the geometry out, but for that of the volume in the mass
   * equation, without which there is no flow.
   *
   * With rotational symmetry (Symmetry) the cell is a ring: V = 2π r̄ A, and strain has the hoop component
   * L_θθ = v_r/r, taken at the centroid, v̄_r/r̄. With η = 1/(3 r̄) it is Σ v_Ir η, and
   *
   *   δV = s V E_Jb, E_J = G_J + η e_r,   δη = −s η² δ_br,   δL_θθ = η w_θJ δ_br, w_θJ = c_J − s L_θθ;
   *
   * V (tr L + L_θθ) is the rate of V. All are regular on the axis, since r̄ > 0. In the plane and in space E_J = G_J.
   */
  template <int dim>
  struct FluidCell
  {
    static constexpr unsigned int n_nodes = dim + 1;

    std::array<Tensor<1, dim>, n_nodes> velocity;
    std::array<Tensor<1, dim>, n_nodes> acceleration;
    std::array<double, n_nodes> pressure;
    std::array<double, n_nodes> old_pressure;
    std::array<double, n_nodes> old_pressure_rate;

    std::array<Tensor<1, dim>, n_nodes> gradients; ///< G_I, 1/m
    double volume     = 0.;
    double old_volume = 0.; ///< at the start of the step; with rotational symmetry the area in the plane

    Tensor<2, dim> velocity_gradient; ///< L_ij = ∂v_i/∂x_j
    SymmetricTensor<2, dim> deviator; ///< in-plane part of d'
    double strain_rate = 0.;          ///< γ̇ = sqrt(2 d':d')

    double time_step                                = 0.;   ///< Δt, s
    std::array<double, n_nodes> velocity_factor     = {};   ///< c_J
    std::array<double, n_nodes> acceleration_factor = {};   ///< derivative of the acceleration, 1/s
    double motion                                   = 0.;   ///< s: Δt or zero
    std::array<std::array<Tensor<1, dim>, dim>, n_nodes> w; ///< w_Jb
    std::array<Tensor<1, dim>, n_nodes> expansion;          ///< E_J, 1/m

    bool is_ring                           = Symmetry::applies<dim>();
    double section                         = 0.; ///< A, in the plane; #volume without rotational symmetry
    double hoop_rate                       = 0.; ///< L_θθ, 1/s
    double hoop_gradient                   = 0.; ///< η, 1/m
    std::array<double, n_nodes> hoop_w     = {}; ///< w_θJ
    std::array<double, n_nodes> radius     = {}; ///< r_I, m
    std::array<double, n_nodes> old_shares = {}; ///< body_volume_shares() at the start of the step

    Tensor<1, dim> gravity;
    const FluidLaw *law            = nullptr;
    double stabilization           = 0.;  ///< τ_s, m³ s/kg
    double stabilization_viscosity = 0.;  ///< viscosity in the stabilisation terms, Pa s
    Tensor<1, dim> residual_projection;   ///< mean of π over the corners, see ResidualProjection; N/m³
    SymmetricTensor<2, dim> plastic_dual; ///< Λ of the primal–dual Newton scheme
    SymmetricTensor<2, dim> multiplier;   ///< Λ_k of an exact yield stress, see ExactPlasticStress

    /// Compute everything that follows from the corners @p x and #velocity. Without volume only #volume is set.
    void reinit(const std::array<Point<dim>, n_nodes> &x, const bool linearize_motion);

    /// The rate e' to which the plastic part of the stress belongs, τ0 f(ε̇) 2 e' with ε̇ = sqrt(2 e':e'), in-plane part:
    /// d', and where the yield stress is exact d' + Λ_k/(2 r).
    SymmetricTensor<2, dim> plastic_rate() const
    {
      const double r = law->augmentation();
      return r > 0. ? deviator + multiplier / (2. * r) : deviator;
    }

    /// ε̇ of plastic_rate().
    double plastic_strain_rate() const
    {
      return law->augmentation() > 0. ? 2. * deviator_norm<dim>(plastic_rate()) : strain_rate;
    }

    double mean_pressure() const
    {
      double sum = 0.;
      for (const double p : pressure)
        sum += p / n_nodes;
      return sum;
    }

    /// P = max(−p̄, 0), p̄ the mean pressure: what laws of fluids know of it.
    double confining_pressure() const
    {
      return std::max(-mean_pressure(), 0.);
    }

    Tensor<1, dim> mean_acceleration() const
    {
      Tensor<1, dim> sum;
      for (const Tensor<1, dim> &a : acceleration)
        sum += a / n_nodes;
      return sum;
    }

    Tensor<1, dim> pressure_gradient() const
    {
      Tensor<1, dim> sum;
      for (unsigned int I = 0; I < n_nodes; ++I)
        sum += pressure[I] * gradients[I];
      return sum;
    }

    /// ∇p + ρ g − ρ ā, with @p inertia_density for ρ in the last term.
    Tensor<1, dim> momentum_residual(const double inertia_density) const
    {
      return pressure_gradient() + law->density() * gravity - inertia_density * mean_acceleration();
    }

    /// The edge of the equilateral simplex with the same volume, m.
    double edge() const
    {
      return dim == 2 ? std::sqrt(4. / std::sqrt(3.) * section) : std::cbrt(6. * std::sqrt(2.) * section);
    }

    /// ∫ N_I N_J over the cell, divided by its volume.
    double mass(const unsigned int I, const unsigned int J) const
    {
      if constexpr (dim == 2)
        if (is_ring)
        {
          double sum = 0.;
          for (unsigned int K = 0; K < n_nodes; ++K)
            sum += product_of_three(I, J, K) * radius[K];
          return 3. * hoop_gradient * sum;
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
        sum += 2. * numbers::PI * section * product_of_three(I, J, K) * x[J];
      return sum;
    }

    /// The same of ∫ N_I.
    double share_by_radius(const unsigned int I, const unsigned int K) const
    {
      return 2. * numbers::PI * section / 12. * (I == K ? 2. : 1.);
    }

    /// ∫ N_I over a ring.
    double share(const unsigned int I) const
    {
      return ring_share(section, 1. / hoop_gradient, radius[I]);
    }

    /// a:b of deviators, with their components out of the plane where these are those of a hoop.
    double product(const SymmetricTensor<2, dim> &a, const SymmetricTensor<2, dim> &b) const
    {
      return is_ring ? a * b + trace(a) * trace(b) : a * b;
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
  };

  /// Residual and Jacobian of one cell; node I has the velocity rows (I, 0 … dim−1) and the pressure row (I, dim).
  template <int dim>
  struct CellSystem
  {
    static constexpr unsigned int n_components = dim + 1;
    static constexpr unsigned int n_unknowns   = (dim + 1) * n_components;

    std::array<std::array<double, n_unknowns>, n_unknowns> matrix;
    std::array<double, n_unknowns> residual;

    static constexpr unsigned int index(const unsigned int node, const unsigned int component)
    {
      return node * n_components + component;
    }

    static constexpr unsigned int pressure_index(const unsigned int node)
    {
      return node * n_components + dim;
    }

    void clear()
    {
      for (auto &row : matrix)
        row.fill(0.);
      residual.fill(0.);
    }
  };
} // namespace Lahar

#endif
