// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_fluid_cell_h
#define lahar_assembly_fluid_cell_h

#include <lahar/assembly/cell_flow.h>
#include <lahar/assembly/deviator.h>
#include <lahar/assembly/fluid_state.h>
#include <lahar/material/fluid_law.h>

#include <array>

namespace Lahar
{
  /**
   * What the terms of the weak form need to know of one linear simplex at the end of the step.
   *
   * The unknown is the corners' mean velocity in the step (TimeIntegration). G_I = ∇N_I and V are those of the present
   * configuration, v_I velocities at its time, L = Σ v_I ⊗ G_I (CellFlow). When the mean velocity of node J changes in
   * direction e_b, v_J changes by c_J e_b and the node moves by s e_b, s = Δt, so that
   *
   *   δV = s V G_Jb,   δG_I = −s G_Ib G_J,   δL = w_Jb ⊗ G_J with w_Jb = c_J e_b − s L e_b.
   *
   * With s = 0 in motion() the terms leave the derivatives of the geometry out, but for that of the volume in the mass
   * equation, without which there is no flow.
   *
   * With rotational symmetry (Symmetry), η = 1/(3 r̄),
   *
   *   δV = s V E_Jb, E_J = G_J + η e_r,   δη = −s η² δ_br,   δL_θθ = η w_θJ δ_br, w_θJ = c_J − s L_θθ.
   *
   * In the plane and in space E_J = G_J.
   *
   * The constructor is the only one who writes: a cell is what the state, the law and the kind of linearisation make of it,
   * and cannot be changed afterwards.
   */
  template <int dim>
  class FluidCell : public CellFlow<dim>
  {
  public:
    using CellFlow<dim>::n_nodes;

    /**
     * @param state for which FluidAssembler::set_stabilization() has been called. @param c number of the cell, which has
     * the corners @p vertices and belongs to the fluid of the number @p fluid with the law @p law; the law must live as
     * long as this.
     * @param linearize_motion whether s = Δt; it is zero all the same for slivers, whose shape stays, and for cells that
     * keep less than 0.7 of their volume in the step.
     */
    FluidCell(const FluidState<dim> &state, const unsigned int c, const Simplex<dim> &vertices,
              const unsigned int fluid, const FluidLaw &law, const bool linearize_motion);

    const FluidLaw &law() const
    {
      return *cell_law;
    }

    /// dv/dt of the corners at the end of the step, m/s².
    const std::array<Tensor<1, dim>, n_nodes> &acceleration() const
    {
      return a;
    }

    /// At the start of the step, Pa.
    const std::array<double, n_nodes> &old_pressure() const
    {
      return p_old;
    }

    /// Its derivative there, Pa/s.
    const std::array<double, n_nodes> &old_pressure_rate() const
    {
      return p_rate_old;
    }

    /// V at the start of the step; with rotational symmetry the area in the plane.
    double old_volume() const
    {
      return V_old;
    }

    /// With rotational symmetry body_volume_shares() at the start of the step.
    const std::array<double, n_nodes> &old_shares() const
    {
      return shares_old;
    }

    /// Δt, s.
    double time_step() const
    {
      return dt;
    }

    /// c_J.
    const std::array<double, n_nodes> &velocity_factor() const
    {
      return c_v;
    }

    /// Derivative of the acceleration, 1/s.
    const std::array<double, n_nodes> &acceleration_factor() const
    {
      return c_a;
    }

    /// s: Δt or zero.
    double motion() const
    {
      return s;
    }

    /// w_Jb.
    const std::array<std::array<Tensor<1, dim>, dim>, n_nodes> &w() const
    {
      return delta_L;
    }

    /// w_θJ.
    const std::array<double, n_nodes> &hoop_w() const
    {
      return delta_L_hoop;
    }

    /// E_J, 1/m.
    const std::array<Tensor<1, dim>, n_nodes> &expansion() const
    {
      return E;
    }

    /// m/s².
    const Tensor<1, dim> &gravity() const
    {
      return g;
    }

    /// τ_s, m³ s/kg.
    double stabilization() const
    {
      return tau_s;
    }

    /// Viscosity in the stabilisation terms, Pa s.
    double stabilization_viscosity() const
    {
      return mu_s;
    }

    /// Mean of π over the corners, see ResidualProjection; N/m³.
    const Tensor<1, dim> &residual_projection() const
    {
      return pi;
    }

    /// Λ of the primal–dual Newton scheme; zero before it is started.
    const SymmetricTensor<2, dim> &plastic_dual() const
    {
      return dual;
    }

    /// Λ_k of an exact yield stress, see ExactPlasticStress; zero for other laws.
    const SymmetricTensor<2, dim> &multiplier() const
    {
      return Lambda_k;
    }

    /// λ of Thixotropy; zero for other laws.
    double structure() const
    {
      return lambda;
    }

    /// The rate e' to which the plastic part of the stress belongs, τ0 f(ε̇) 2 e' with ε̇ = sqrt(2 e':e'), in-plane part:
    /// d', and where the yield stress is exact d' + Λ_k/(2 r).
    SymmetricTensor<2, dim> plastic_rate() const
    {
      const double r = law().augmentation();
      return r > 0. ? this->deviator() + Lambda_k / (2. * r) : this->deviator();
    }

    /// P of the law, see CellFlow.
    double confining_pressure() const
    {
      return P;
    }

    /// ∇p_w of the law's PoreWater at the corner @p J, Pa/m.
    Tensor<1, dim> pore_pressure_gradient(const unsigned int J) const
    {
      return law().pore_water().gradient(this->corners()[J], g);
    }

    /// (1 + λ) τ_y of the law.
    FluidLaw::Value yield_stress() const
    {
      return law().structured_yield_stress(P, lambda);
    }

    /// μ_eff of the law.
    FluidLaw::Value effective_viscosity() const
    {
      return law().effective_viscosity(this->strain_rate(), P, lambda);
    }

    /// ε̇ of plastic_rate().
    double plastic_strain_rate() const
    {
      return law().augmentation() > 0. ? 2. * deviator_norm<dim>(plastic_rate()) : this->strain_rate();
    }

    Tensor<1, dim> mean_acceleration() const
    {
      Tensor<1, dim> sum;
      for (const Tensor<1, dim> &a_I : a)
        sum += a_I / n_nodes;
      return sum;
    }

    /// ∇p + ρ g − ρ ā, with @p inertia_density for ρ in the last term.
    Tensor<1, dim> momentum_residual(const double inertia_density) const
    {
      return this->pressure_gradient() + law().density() * g - inertia_density * mean_acceleration();
    }

  private:
    const FluidLaw *cell_law;
    std::array<Tensor<1, dim>, n_nodes> a;
    std::array<double, n_nodes> p_old, p_rate_old;
    double V_old                           = 0.;
    std::array<double, n_nodes> shares_old = {};
    double dt;
    std::array<double, n_nodes> c_v, c_a;
    double s = 0.;
    std::array<std::array<Tensor<1, dim>, dim>, n_nodes> delta_L;
    std::array<double, n_nodes> delta_L_hoop = {};
    std::array<Tensor<1, dim>, n_nodes> E;
    Tensor<1, dim> g;
    double P;
    double tau_s, mu_s;
    Tensor<1, dim> pi;
    SymmetricTensor<2, dim> dual, Lambda_k;
    double lambda;
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
