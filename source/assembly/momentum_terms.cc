// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/stiffening.h>
#include <lahar/assembly/terms.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  namespace
  {
  }



  template <int dim>
  void Inertia<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S              = CellSystem<dim>;
    const double mass    = cell.law().density() * cell.volume();
    constexpr unsigned n = dim + 1;
    for (unsigned int I = 0; I < n; ++I)
    {
      Tensor<1, dim> force;
      for (unsigned int J = 0; J < n; ++J)
        force += mass * cell.mass(I, J) * cell.acceleration()[J];
      for (unsigned int a = 0; a < dim; ++a)
      {
        system.residual[S::index(I, a)] += force[a];
        for (unsigned int J = 0; J < n; ++J)
        {
          system.matrix[S::index(I, a)][S::index(J, a)] += mass * cell.mass(I, J) *
                                                           cell.acceleration_factor()[J];
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::index(I, a)][S::index(J, b)] += cell.motion() * cell.gradients()[J][b] *
                                                             force[a];
        }
      }
      if (cell.is_ring())
        for (unsigned int K = 0; K < n; ++K)
        {
          const Tensor<1, dim> by_radius = cell.motion() * cell.law().density() *
                                           cell.mass_by_radius(I, K, cell.acceleration());
          for (unsigned int a = 0; a < dim; ++a)
            system.matrix[S::index(I, a)][S::index(K, radial)] += by_radius[a];
        }
    }
  }



  template <int dim>
  void BodyForce<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S              = CellSystem<dim>;
    Tensor<1, dim> force = -cell.law().density() * cell.volume() / (dim + 1) * cell.gravity();
    for (unsigned int I = 0; I <= dim; ++I)
    {
      if (cell.is_ring())
        force = -cell.law().density() * cell.share(I) * cell.gravity();
      for (unsigned int a = 0; a < dim; ++a)
      {
        system.residual[S::index(I, a)] += force[a];
        for (unsigned int J = 0; J <= dim; ++J)
        {
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::index(I, a)][S::index(J, b)] += cell.motion() * cell.gradients()[J][b] *
                                                             force[a];
          if (cell.is_ring())
            system.matrix[S::index(I, a)][S::index(J, radial)] -= cell.motion() * cell.law().density() *
                                                                  cell.share_by_radius(I, J) *
                                                                  cell.gravity()[a];
        }
      }
    }
  }



  namespace
  {
    template <int dim>
    StressTangent<dim> viscous_tangent(const FluidCell<dim> &cell, const double viscosity,
                                       const ViscosityLinearization linearization,
                                       const double plastic_weight)
    {
      StressTangent<dim> tangent;
      tangent.viscosity = viscosity;
      const double rate = cell.strain_rate();
      if (linearization == ViscosityLinearization::picard || rate < std::numeric_limits<double>::min())
        return tangent;

      const double pressure           = cell.confining_pressure();
      const double tau_y              = cell.law().has_exact_yield_stress() ? 0. : cell.yield_stress().value;
      const double viscous_derivative = cell.law().viscous_part(rate, pressure).derivative;
      if (tau_y == 0. && viscous_derivative == 0.)
        return tangent;
      const FluidLaw::Value plastic = cell.law().plastic_part(rate);
      tangent.A                     = cell.deviator();

      tangent.coefficient = 1.;
      // The viscous part's derivative is Newton's in both schemes; −ψ'/ψ = f'/f.
      tangent.B = 2. * viscous_derivative / rate * cell.deviator();
      if (linearization == ViscosityLinearization::newton)
        tangent.B += plastic_weight * 2. * tau_y * plastic.derivative / rate * cell.deviator();
      else if (tau_y > 0.)
      {
        const auto norm_of = [&cell](const SymmetricTensor<2, dim> &t) {
          return std::sqrt(0.5 * cell.product(t, t));
        };
        const double gap    = norm_of(cell.plastic_dual() - 2. * plastic.value * cell.deviator());
        const double norm   = norm_of(cell.plastic_dual());
        const double weight = std::min(plastic_weight,
                                       1. - std::min(largest_stiffening, stiffening_rate * gap));
        tangent.B += weight * tau_y * plastic.derivative / plastic.value / rate / std::max(1., norm) *
                     cell.plastic_dual();
      }
      return tangent;
    }
  } // namespace



  template <int dim>
  CellStress<dim> ViscousStress<dim>::viscous_part(const FluidCell<dim> &cell) const
  {
    const double viscosity = cell.law().viscous_part(cell.strain_rate(), cell.confining_pressure()).value;
    return {2. * viscosity * cell.deviator(),
            viscous_tangent(cell, viscosity, linearization, plastic_weight)};
  }



  template <int dim>
  void ViscousStress<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    using S              = CellSystem<dim>;
    constexpr unsigned n = dim + 1;
    if (cell.law().has_exact_yield_stress())
    {
      const auto [stress, tangent] = viscous_part(cell);
      assemble_stress(cell, stress, tangent, system);
      return;
    }
    const FluidLaw::Value viscosity      = cell.effective_viscosity();
    const SymmetricTensor<2, dim> stress = 2. * viscosity.value * cell.deviator();
    const StressTangent<dim> tangent = viscous_tangent(cell, viscosity.value, linearization, plastic_weight);

    assemble_stress(cell, stress, tangent, system);

    if (viscosity.pressure_derivative == 0. || linearization == ViscosityLinearization::picard ||
        !(cell.confining_pressure() > 0.))
      return;
    // What moves with its corner J changes p_w there as the pressure p_J would.
    const SymmetricTensor<2, dim> by_pressure = -2. * cell.volume() / n * viscosity.pressure_derivative *
                                                cell.deviator();
    for (unsigned int I = 0; I < n; ++I)
    {
      Tensor<1, dim> column = by_pressure * cell.gradients()[I];
      if (cell.is_ring())
        column[radial] -= cell.hoop_gradient() * trace(by_pressure);
      for (unsigned int J = 0; J < n; ++J)
      {
        const Tensor<1, dim> by_motion = cell.motion() * cell.pore_pressure_gradient(J);
        for (unsigned int a = 0; a < dim; ++a)
        {
          system.matrix[S::index(I, a)][S::pressure_index(J)] += column[a];
          for (unsigned int b = 0; b < dim; ++b)
            system.matrix[S::index(I, a)][S::index(J, b)] += column[a] * by_motion[b];
        }
      }
    }
  }



  template <int dim>
  void PrescribedPressure<dim>::assemble(const FluidCell<dim> &cell,
                                         const std::array<Point<dim>, dim + 1> &corners,
                                         const unsigned int opposite, const FacePressure<dim> &pressure,
                                         CellSystem<dim> &system) const
  {
    Assert(!cell.is_ring(), ExcMessage("Outflow is refused with rotational symmetry."));
    // Area times n of the face is −dim V G_k, k the node opposite to it.
    using S                  = CellSystem<dim>;
    constexpr unsigned n     = dim + 1;
    const auto &G            = cell.gradients();
    const double area_factor = -double(dim) * cell.volume();
    const Tensor<1, dim> &Gk = G[opposite];
    std::array<double, n> p;
    for (unsigned int J = 0; J < n; ++J)
      p[J] = pressure(corners[J]);
    for (unsigned int I = 0; I < n; ++I)
    {
      if (I == opposite)
        continue;
      double share = 0.; // ∫ N_I p over the face, divided by its area
      for (unsigned int J = 0; J < n; ++J)
        if (J != opposite)
          share += cell.face_mass(I, J) * p[J];
      for (unsigned int a = 0; a < dim; ++a)
      {
        system.residual[S::index(I, a)] += area_factor * share * Gk[a];
        for (unsigned int J = 0; J < n; ++J)
          for (unsigned int b = 0; b < dim; ++b)
          {
            double change = share * (G[J][b] * Gk[a] - Gk[b] * G[J][a]);
            if (J != opposite && p[J] > 0.)
              change += cell.face_mass(I, J) * pressure.gradient[b] * Gk[a];
            system.matrix[S::index(I, a)][S::index(J, b)] += cell.motion() * area_factor * change;
          }
      }
    }
  }



  template struct Inertia<2>;
  template struct Inertia<3>;
  template struct BodyForce<2>;
  template struct BodyForce<3>;
  template class ViscousStress<2>;
  template class ViscousStress<3>;
  template struct PrescribedPressure<2>;
  template struct PrescribedPressure<3>;
} // namespace Lahar
