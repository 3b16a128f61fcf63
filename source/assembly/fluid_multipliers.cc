// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_assembler.h>

namespace Lahar
{
  namespace
  {
    /// τ:δL of a deviatoric stress whose in-plane part is given, for @p increment of the velocities by vertex.
    template <int dim>
    double power(const CellFlow<dim> &cell, const SymmetricTensor<2, dim> &stress,
                 const Simplex<dim> &vertices, const std::vector<Tensor<1, dim>> &increment)
    {
      double sum = 0.;
      for (unsigned int I = 0; I <= dim; ++I)
      {
        sum += increment[vertices[I]] * (stress * cell.gradients()[I]);
        if (cell.is_ring())
          sum -= increment[vertices[I]][0] * cell.hoop_gradient() * trace(stress);
      }
      return sum;
    }
  } // namespace



  template <int dim>
  double FluidAssembler<dim>::update_multipliers(const FluidMesh<dim> &mesh, const Materials &materials,
                                                 FluidState<dim> &state,
                                                 const std::vector<Tensor<1, dim>> &increment,
                                                 const std::vector<bool> &counted) const
  {
    double change = 0.;
    for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const FluidLaw &law = materials.law(mesh.fluid(c));
      if (state.left_out[c] || !law.has_exact_yield_stress())
        continue;
      const Simplex<dim> &vertices = mesh.cells()[c];
      const CellFlow<dim> cell(state.shape_of(c, vertices), vertices, state.velocity, state.pressure);
      if (!(cell.volume() > 0.))
        continue;
      const SymmetricTensor<2, dim> step = 2. * law.augmentation() * cell.deviator();
      const SymmetricTensor<2, dim> next = project_deviator<dim>(state.multiplier[c] + step);
      state.multiplier[c]                = next;
      if (counted[c])
        change += cell.volume() * law.structured_yield_stress(0., state.structure_of(c)).value *
                  power(cell, SymmetricTensor<2, dim>(project_deviator<dim>(next + step) - next), vertices,
                        increment);
    }
    return change;
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



  template double FluidAssembler<2>::update_multipliers(const FluidMesh<2> &, const Materials &,
                                                        FluidState<2> &, const std::vector<Tensor<1, 2>> &,
                                                        const std::vector<bool> &) const;
  template double FluidAssembler<3>::update_multipliers(const FluidMesh<3> &, const Materials &,
                                                        FluidState<3> &, const std::vector<Tensor<1, 3>> &,
                                                        const std::vector<bool> &) const;
  template FluidAssembler<2>::YieldGap FluidAssembler<2>::yield_gap(const FluidMesh<2> &, const Materials &,
                                                                    const FluidState<2> &,
                                                                    const std::vector<bool> &) const;
  template FluidAssembler<3>::YieldGap FluidAssembler<3>::yield_gap(const FluidMesh<3> &, const Materials &,
                                                                    const FluidState<3> &,
                                                                    const std::vector<bool> &) const;
} // namespace Lahar
