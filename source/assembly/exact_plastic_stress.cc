// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/exact_plastic_stress.h>
#include <lahar/assembly/stiffening.h>

namespace Lahar
{
  template <int dim>
  SymmetricTensor<2, dim>
  ExactPlasticStress<dim>::rank_one_part(const FluidCell<dim> &cell, const SymmetricTensor<2, dim> &rate,
                                         const double strain_rate, const FluidLaw::Value &f) const
  {
    if (linearization == ViscosityLinearization::picard || f.derivative == 0.)
      return {};
    const double factor = cell.yield_stress().value * f.derivative / strain_rate;
    if (linearization == ViscosityLinearization::newton)
      return 2. * plastic_weight * factor * rate;
    const double gap    = deviator_norm<dim>(cell.plastic_dual() - 2. * f.value * rate);
    const double weight = std::min(plastic_weight, 1. - std::min(largest_stiffening, stiffening_rate * gap));
    return weight * factor / f.value * project_deviator<dim>(cell.plastic_dual());
  }



  template <int dim>
  CellStress<dim> ExactPlasticStress<dim>::stress(const FluidCell<dim> &cell) const
  {
    const SymmetricTensor<2, dim> rate = cell.plastic_rate();
    const double strain_rate           = 2. * deviator_norm<dim>(rate);
    const FluidLaw::Value f            = cell.law().plastic_part(strain_rate);
    const double viscosity             = cell.yield_stress().value * f.value;
    return {2. * viscosity * rate, {viscosity, 1., rate, rank_one_part(cell, rate, strain_rate, f)}};
  }



  template <int dim>
  void ExactPlasticStress<dim>::assemble(const FluidCell<dim> &cell, CellSystem<dim> &system) const
  {
    const auto [of_cell, tangent] = stress(cell);
    assemble_stress(cell, of_cell, tangent, system);
  }



  template class ExactPlasticStress<2>;
  template class ExactPlasticStress<3>;
} // namespace Lahar
