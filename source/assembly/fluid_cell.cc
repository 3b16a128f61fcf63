// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_cell.h>
#include <lahar/geometry/simplex_geometry.h>

namespace Lahar
{
  template <int dim>
  void FluidCell<dim>::reinit(const std::array<Point<dim>, n_nodes> &x, const bool linearize_motion)
  {
    volume = signed_volume<dim>(x);
    if (!(volume > 0.))
      return;
    gradients = shape_gradients<dim>(x);

    velocity_gradient = Tensor<2, dim>();
    for (unsigned int I = 0; I < n_nodes; ++I)
      velocity_gradient += outer_product(velocity[I], gradients[I]);

    // The deviator's out-of-plane component is −tr(d)/3 in plane strain and counts in γ̇.
    const double third = trace(velocity_gradient) / 3.;
    deviator           = symmetrize(velocity_gradient) - third * unit_symmetric_tensor<dim>();
    strain_rate        = std::sqrt(2. * (deviator * deviator + (3 - dim) * third * third));

    motion = linearize_motion ? time_step : 0.;
    for (unsigned int J = 0; J < n_nodes; ++J)
      for (unsigned int b = 0; b < dim; ++b)
        for (unsigned int i = 0; i < dim; ++i)
          w[J][b][i] = (i == b ? velocity_factor[J] : 0.) - motion * velocity_gradient[i][b];
  }



  template struct FluidCell<2>;
  template struct FluidCell<3>;
} // namespace Lahar
