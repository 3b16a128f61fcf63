// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_assembly_deviator_h
#define lahar_assembly_deviator_h

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace Lahar
{
  using namespace dealii;

  /// A:B of two three-dimensional deviators whose in-plane parts are given: in plane strain they have the out-of-plane
  /// components −tr A and −tr B.
  template <int dim>
  double deviator_product(const SymmetricTensor<2, dim> &a, const SymmetricTensor<2, dim> &b)
  {
    return a * b + (3 - dim) * trace(a) * trace(b);
  }

  /// |A| = sqrt(A:A/2) of such a deviator.
  template <int dim>
  double deviator_norm(const SymmetricTensor<2, dim> &a)
  {
    return std::sqrt(0.5 * deviator_product<dim>(a, a));
  }

  /// P(A) = A/max(1, |A|).
  template <int dim>
  SymmetricTensor<2, dim> project_deviator(const SymmetricTensor<2, dim> &a)
  {
    return a / std::max(1., deviator_norm<dim>(a));
  }
} // namespace Lahar

#endif
