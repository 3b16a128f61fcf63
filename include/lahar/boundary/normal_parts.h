// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_boundary_normal_parts_h
#define lahar_boundary_normal_parts_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// The parts λ_k of @p force along @p normals that are independent of each other: the force is Σ λ_k n_k and a rest that
  /// is normal to all of them.
  template <int dim>
  std::vector<double> normal_parts(const std::vector<Tensor<1, dim>> &normals, const Tensor<1, dim> &force);
} // namespace Lahar

#endif
