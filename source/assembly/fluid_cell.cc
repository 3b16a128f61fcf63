// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_cell.h>

namespace Lahar
{
  namespace
  {
    /// Cells that keep less than this part of their volume in the step leave the derivatives of their geometry out.
    constexpr double smallest_volume_ratio = 0.7;
  } // namespace



  template <int dim>
  FluidCell<dim>::FluidCell(const FluidState<dim> &state, const unsigned int c, const Simplex<dim> &vertices,
                            const unsigned int fluid, const FluidLaw &law, const bool linearize_motion)
    : CellFlow<dim>(state.shape_of(c, vertices), vertices, state.velocity, state.pressure)
    , cell_law(&law)
    , dt(state.time_step)
    , g(state.gravity)
    , P(CellFlow<dim>::confining_pressure(law, state.gravity))
    , tau_s(state.stabilization[c])
    , mu_s(state.stabilization_viscosity[c])
    , pi(state.projection_of(c, vertices, fluid))
    , lambda(state.structure_of(c))
  {
    const SimplexCorners<dim> old_corners = corners_of<dim>(vertices, state.old_position);
    V_old                                 = signed_volume<dim>(old_corners);
    if (this->is_ring())
      shares_old = body_volume_shares<dim>(old_corners);
    for (unsigned int I = 0; I < n_nodes; ++I)
    {
      a[I]          = state.acceleration[vertices[I]];
      p_old[I]      = state.old_pressure[vertices[I]];
      p_rate_old[I] = state.old_pressure_rate[vertices[I]];
      c_v[I]        = state.velocity_factor[vertices[I]];
      c_a[I]        = state.acceleration_factor[vertices[I]];
    }
    if (!state.plastic_dual.empty())
      dual = state.plastic_dual[c];
    if (law.has_exact_yield_stress())
      Lambda_k = state.multiplier[c];
    if (!(this->volume() > 0.))
      return;

    if (linearize_motion && !state.sliver[c] && this->section() > smallest_volume_ratio * V_old)
      s = dt;
    E = this->gradients();
    if (this->is_ring())
      for (unsigned int J = 0; J < n_nodes; ++J)
      {
        E[J][0] += this->hoop_gradient();
        delta_L_hoop[J] = c_v[J] - s * this->hoop_rate();
      }
    const Tensor<2, dim> &L = this->velocity_gradient();
    for (unsigned int J = 0; J < n_nodes; ++J)
      for (unsigned int b = 0; b < dim; ++b)
        for (unsigned int i = 0; i < dim; ++i)
          delta_L[J][b][i] = (i == b ? c_v[J] : 0.) - s * L[i][b];
  }



  template class FluidCell<2>;
  template class FluidCell<3>;
} // namespace Lahar
