// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/cell_flow.h>

namespace Lahar
{
  template <int dim>
  CellFlow<dim>::CellFlow(const SimplexCorners<dim> &corners, const Simplex<dim> &vertices,
                          const std::vector<Tensor<1, dim>> &velocities, const std::vector<double> &pressures)
    : x(corners)
  {
    for (unsigned int I = 0; I < n_nodes; ++I)
    {
      v[I] = velocities[vertices[I]];
      p[I] = pressures[vertices[I]];
    }
    A = signed_volume<dim>(x);
    V = ring && A > 0. ? body_volume<dim>(x) : A;
    if (!(V > 0.))
      return;
    G = shape_gradients<dim>(x);
    for (unsigned int I = 0; I < n_nodes; ++I)
      L += outer_product(v[I], G[I]);
    if (ring)
    {
      double sum_of_radii = 0., sum_of_velocities = 0.;
      for (unsigned int I = 0; I < n_nodes; ++I)
      {
        radius[I] = x[I][0];
        sum_of_radii += radius[I];
        sum_of_velocities += v[I][0];
      }
      eta    = 1. / sum_of_radii;
      L_hoop = eta * sum_of_velocities;
    }

    // The deviator's out-of-plane component, −tr(d)/3 in plane strain, counts in γ̇.
    const double third        = (trace(L) + L_hoop) / 3.;
    const double out_of_plane = L_hoop - third;
    d                         = symmetrize(L) - third * unit_symmetric_tensor<dim>();
    gamma                     = std::sqrt(2. * (d * d + (3 - dim) * out_of_plane * out_of_plane));
  }



  template class CellFlow<2>;
  template class CellFlow<3>;
} // namespace Lahar
