// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_schur_complement_h
#define lahar_linear_schur_complement_h

#include <Epetra_CrsMatrix.h>

#include <lahar/linear/block_system.h>

#include <memory>

namespace Lahar
{
  /// S = H − C diag(K)⁻¹ Q, an approximation of the pressure's Schur complement H − C K⁻¹ Q.
  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix> make_schur_complement(const BlockSystem<dim> &system);
} // namespace Lahar

#endif
