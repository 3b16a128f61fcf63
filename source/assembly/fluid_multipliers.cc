// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_assembler.h>

namespace Lahar
{
  template <int dim>
  void FluidAssembler<dim>::update_multipliers(const FluidMesh<dim> &mesh, const Materials &materials,
                                               FluidState<dim> &state) const
  {
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      if (state.left_out[c])
        continue;
      const FluidCell<dim> cell = make_cell(mesh, materials, state, c);
      if (cell.volume() > 0.)
        state.multiplier[c] = project_deviator<dim>(2. * cell.law().augmentation() * cell.plastic_rate());
    }
  }



  template <int dim>
  typename FluidAssembler<dim>::YieldGap
  FluidAssembler<dim>::yield_gap(const FluidMesh<dim> &mesh, const Materials &materials,
                                 const FluidState<dim> &state, const std::vector<bool> &counted) const
  {
    YieldGap result;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      if (state.left_out[c] || !counted[c])
        continue;
      const FluidLaw &law = materials.law(mesh.fluid(c));
      if (!materials.counts_in_gap(mesh.fluid(c)))
        continue;
      const FluidCell<dim> cell = make_cell(mesh, materials, state, c);
      if (!(cell.volume() > 0.))
        continue;
      const double f    = law.plastic_part(cell.plastic_strain_rate()).value;
      const double work = 2. * f * deviator_product<dim>(cell.plastic_rate(), cell.deviator());
      result.gap += cell.yield_stress().value * cell.volume() * std::max(0., cell.strain_rate() - work);
      double inertia = 0.;
      for (unsigned int I = 0; I <= dim; ++I)
        for (unsigned int J = 0; J <= dim; ++J)
          inertia += cell.mass(I, J) * cell.acceleration_factor()[I] / cell.velocity_factor()[I] *
                     (cell.velocity()[I] * cell.velocity()[J]);
      result.energy += cell.volume() *
                       (law.density() * inertia +
                        law.viscous_part(cell.strain_rate(), cell.confining_pressure()).value *
                          cell.strain_rate() * cell.strain_rate());
    }
    return result;
  }



  template void FluidAssembler<2>::update_multipliers(const FluidMesh<2> &, const Materials &,
                                                      FluidState<2> &) const;
  template void FluidAssembler<3>::update_multipliers(const FluidMesh<3> &, const Materials &,
                                                      FluidState<3> &) const;
  template FluidAssembler<2>::YieldGap FluidAssembler<2>::yield_gap(const FluidMesh<2> &, const Materials &,
                                                                    const FluidState<2> &,
                                                                    const std::vector<bool> &) const;
  template FluidAssembler<3>::YieldGap FluidAssembler<3>::yield_gap(const FluidMesh<3> &, const Materials &,
                                                                    const FluidState<3> &,
                                                                    const std::vector<bool> &) const;
} // namespace Lahar
