// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/fluid_cell.h>
#include <lahar/geometry/simplex_geometry.h>

namespace Lahar
{
  template <int dim>
  void FluidCell<dim>::reinit(const std::array<Point<dim>, n_nodes> &x, const bool linearize_motion)
  {
    section = signed_volume<dim>(x);
    volume  = is_ring && section > 0. ? body_volume<dim>(x) : section;
    if (!(volume > 0.))
      return;
    gradients = shape_gradients<dim>(x);

    velocity_gradient = Tensor<2, dim>();
    for (unsigned int I = 0; I < n_nodes; ++I)
      velocity_gradient += outer_product(velocity[I], gradients[I]);

    motion    = linearize_motion ? time_step : 0.;
    expansion = gradients;
    if (is_ring)
    {
      double sum_of_radii = 0., sum_of_velocities = 0.;
      for (unsigned int I = 0; I < n_nodes; ++I)
      {
        radius[I] = x[I][0];
        sum_of_radii += radius[I];
        sum_of_velocities += velocity[I][0];
      }
      hoop_gradient = 1. / sum_of_radii;
      hoop_rate     = hoop_gradient * sum_of_velocities;
      for (unsigned int J = 0; J < n_nodes; ++J)
      {
        expansion[J][0] += hoop_gradient;
        hoop_w[J] = velocity_factor[J] - motion * hoop_rate;
      }
    }

    // The deviator's out-of-plane component, −tr(d)/3 in plane strain, counts in γ̇.
    const double third        = (trace(velocity_gradient) + hoop_rate) / 3.;
    const double out_of_plane = hoop_rate - third;
    deviator                  = symmetrize(velocity_gradient) - third * unit_symmetric_tensor<dim>();
    strain_rate = std::sqrt(2. * (deviator * deviator + (3 - dim) * out_of_plane * out_of_plane));

    for (unsigned int J = 0; J < n_nodes; ++J)
      for (unsigned int b = 0; b < dim; ++b)
        for (unsigned int i = 0; i < dim; ++i)
          w[J][b][i] = (i == b ? velocity_factor[J] : 0.) - motion * velocity_gradient[i][b];
  }



  template struct FluidCell<2>;
  template struct FluidCell<3>;
} // namespace Lahar
