// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/assembly/residual_projection.h>

#include <algorithm>

namespace Lahar
{
  template <int dim>
  ResidualProjection<dim>::ResidualProjection(const unsigned int n_vertices)
    : residuals(n_vertices)
    , volumes(n_vertices, 0.)
    , bounds(n_vertices, 0.)
  {}



  template <int dim>
  void ResidualProjection<dim>::add(const std::array<unsigned int, dim + 1> &vertices,
                                    const FluidCell<dim> &cell)
  {
    const Tensor<1, dim> residual = cell.volume() * cell.momentum_residual(cell.law().density());
    const double pressure         = cell.confining_pressure();
    double stress                 = cell.effective_viscosity().value * cell.strain_rate();
    if (cell.law().has_exact_yield_stress()) // of which a plug that does not move has one, too
      stress = cell.law().viscous_part(cell.strain_rate(), pressure).value * cell.strain_rate() +
               cell.yield_stress().value * cell.law().plastic_part(cell.plastic_strain_rate()).value *
                 cell.plastic_strain_rate();
    const double bound = 2. * stress / cell.edge();
    for (const unsigned int v : vertices)
    {
      residuals[v] += residual;
      volumes[v] += cell.volume();
      bounds[v] = std::max(bounds[v], bound);
    }
  }



  template <int dim>
  std::vector<Tensor<1, dim>> ResidualProjection<dim>::compute() const
  {
    std::vector<Tensor<1, dim>> result(residuals.size());
    for (unsigned int v = 0; v < residuals.size(); ++v)
      if (volumes[v] > 0.)
      {
        result[v]         = residuals[v] / volumes[v];
        const double norm = result[v].norm();
        if (norm > bounds[v])
          result[v] *= bounds[v] / norm;
      }
    return result;
  }



  template class ResidualProjection<2>;
  template class ResidualProjection<3>;
} // namespace Lahar
