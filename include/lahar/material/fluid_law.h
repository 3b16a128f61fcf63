// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_material_fluid_law_h
#define lahar_material_fluid_law_h

#include <lahar/material/pore_water.h>
#include <lahar/material/thixotropy.h>
#include <lahar/utilities/parameters.h>

#include <memory>

namespace Lahar
{
  /**
   * A generalised Newtonian fluid with a yield stress:
   *
   *   τ = 2 μ_eff d',   μ_eff(γ̇, P) = μ(γ̇, P) + τ_y(P) f(γ̇),   γ̇ = sqrt(2 d':d'),
   *
   * d' the three-dimensional deviator of the rate of deformation (in plane strain it has an out-of-plane component).
   * μ is the viscous part and τ_y f the plastic part; τ_y f γ̇ → τ_y for large γ̇. The two are kept apart because the
   * primal–dual Newton scheme treats the plastic part in its own way (ViscosityLinearization::primal_dual).
   * With Thixotropy the plastic part is (1 + λ) τ_y f, λ the structure parameter; what a law tells of its yield stress is
   * that of fluid without structure.
   * P ≥ 0 is the pressure of a cell above that of its pore water where it is compressed, zero elsewhere, see
   * CellFlow::confining_pressure(). Most laws leave it out; in those of grains friction grows with it.
   * In incompressible flow d' = d and γ̇ is Franci & Zhang's (2018, eq. 8) equivalent strain rate; taking the deviator
   * keeps the tangent symmetric where the discrete flow is not exactly divergence free.
   */
  class FluidLaw
  {
  public:
    /// A function of γ̇ and P and its derivatives.
    struct Value
    {
      double value               = 0.;
      double derivative          = 0.; ///< with respect to γ̇
      double pressure_derivative = 0.; ///< with respect to P
    };

    virtual ~FluidLaw() = default;

    /// ρ, kg/m³.
    double density() const
    {
      return rho;
    }

    /// 1/κ, 1/Pa; zero for an incompressible fluid.
    double compressibility() const
    {
      return inverse_bulk_modulus;
    }

    /// τ_y(P), Pa; zero for a fluid without yield stress. It does not fall with @p pressure, and is above zero under any
    /// pressure unless it is zero under all.
    virtual Value yield_stress(const double /*pressure*/) const
    {
      return {};
    }

    /// Whether τ_y is above zero anywhere.
    bool has_yield_stress() const
    {
      return yield_stress(1.).value > 0.;
    }

    /// Viscous part μ(γ̇, P), Pa s.
    virtual Value viscous_part(const double strain_rate, const double pressure) const = 0;

    /// f(γ̇), s: the plastic part of the viscosity per unit yield stress.
    virtual Value plastic_part(const double strain_rate) const;

    /**
     * r, s, of a yield stress that is not regularised; zero of one that is. There plastic_part() is Huber's
     * f(γ̇) = min(r, 1/γ̇), and the method of multipliers (ExactPlasticStress) takes what it regularises away: the result
     * does not depend on r. Such a yield stress does not depend on the pressure.
     */
    virtual double augmentation() const
    {
      return 0.;
    }

    /// Whether there is a yield stress that is not regularised.
    bool has_exact_yield_stress() const
    {
      return augmentation() > 0. && yield_stress(0.).value > 0.;
    }

    /// How the yield stress builds up and breaks down; by default it does not.
    const Thixotropy &thixotropy() const
    {
      return structure_law;
    }

    /// The water between grains, of whose pressure P is free; by default there is none.
    const PoreWater &pore_water() const
    {
      return water;
    }

    /// (1 + λ) τ_y(P).
    Value structured_yield_stress(const double pressure, const double structure) const
    {
      const Value tau_y = yield_stress(pressure);
      return {(1. + structure) * tau_y.value, 0., (1. + structure) * tau_y.pressure_derivative};
    }

    /// μ_eff(γ̇, P) and its derivatives.
    Value effective_viscosity(const double strain_rate, const double pressure,
                              const double structure = 0.) const;

    /// Whether the stress intensity |τ| = μ_eff γ̇ exceeds the yield stress (always, where there is none).
    bool is_yielded(const double strain_rate, const double pressure, const double structure = 0.) const;

    /// Whether there are states at which is_well_posed() says no.
    virtual bool may_be_ill_posed() const
    {
      return false;
    }

    /// Whether small disturbances of short waves stay small in the incompressible flow of this fluid at the given state, so
    /// that the solution does not depend on the mesh. Laws that know nothing of it say yes.
    virtual bool is_well_posed(const double /*strain_rate*/, const double /*pressure*/) const
    {
      return true;
    }

    /// Declare the entry 'Law' and the laws' subsections in the handler's current section.
    static void declare_parameters(Parameters &prm);

    /// Create the law that 'Law' in the handler's current section names. @throws InputError
    static std::unique_ptr<FluidLaw> create(Parameters &prm);

    /// Read the law's own subsection. A derived class calls this and reads its own entries.
    virtual void parse_parameters(Parameters &prm);

  protected:
    /// Declare what all laws share: `Density` and `Bulk modulus`.
    static void declare_common_parameters(Parameters &prm);

    Thixotropy structure_law; ///< for a law that has its entries
    PoreWater water;          ///< the same

  private:
    double rho                  = 1000.;
    double inverse_bulk_modulus = 0.;
  };
} // namespace Lahar

#endif
