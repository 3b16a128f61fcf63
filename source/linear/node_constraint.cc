// SPDX-License-Identifier: GPL-3.0-or-later

#include <lahar/linear/node_constraint.h>

#include <cmath>

namespace Lahar
{
  namespace
  {
    /// Turn the dim entries that @p entry(a) gives a reference to into @p frame.
    template <int dim, typename Entry>
    void turn(const Tensor<2, dim> &frame, const Entry &entry)
    {
      Tensor<1, dim> old;
      for (unsigned int a = 0; a < dim; ++a)
        old[a] = entry(a);
      for (unsigned int a = 0; a < dim; ++a)
        entry(a) = frame[a] * old;
    }
  } // namespace



  template <int dim>
  void eliminate_prescribed(const std::array<const NodeConstraint<dim> *, dim + 1> &constraints,
                            LocalMatrix<dim> &matrix, LocalVector<dim> &residual)
  {
    constexpr unsigned int n = (dim + 1) * (dim + 1);
    for (unsigned int I = 0; I < dim + 1; ++I)
      if (constraints[I]->n_fixed > 0 && constraints[I]->n_fixed < dim)
      {
        const Tensor<2, dim> &frame = constraints[I]->frame;
        const unsigned int first    = I * (dim + 1);
        for (unsigned int k = 0; k < n; ++k)
          turn(frame, [&](const unsigned int a) -> double & { return matrix[first + a][k]; });
        for (unsigned int k = 0; k < n; ++k)
          turn(frame, [&](const unsigned int a) -> double & { return matrix[k][first + a]; });
        turn(frame, [&](const unsigned int a) -> double & { return residual[first + a]; });
      }

    for (unsigned int I = 0; I < dim + 1; ++I)
      for (unsigned int component = 0; component < dim + 1; ++component)
        if (component < dim ? component < constraints[I]->n_fixed : constraints[I]->fixed_pressure)
        {
          const unsigned int i  = I * (dim + 1) + component;
          const double diagonal = matrix[i][i];
          matrix[i].fill(0.);
          for (unsigned int k = 0; k < n; ++k)
            matrix[k][i] = 0.;
          matrix[i][i] = std::abs(diagonal);
          residual[i]  = 0.;
        }
  }



  template void eliminate_prescribed<2>(const std::array<const NodeConstraint<2> *, 3> &, LocalMatrix<2> &,
                                        LocalVector<2> &);
  template void eliminate_prescribed<3>(const std::array<const NodeConstraint<3> *, 4> &, LocalMatrix<3> &,
                                        LocalVector<3> &);
} // namespace Lahar
