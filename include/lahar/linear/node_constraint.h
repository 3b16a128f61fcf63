// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_linear_node_constraint_h
#define lahar_linear_node_constraint_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Lahar
{
  using namespace dealii;

  /**
   * Which velocity components of a node are prescribed: the first #n_fixed ones in the orthonormal basis whose vectors
   * are the rows of #frame. A free node has none, one that sticks all, one that slides one for each wall normal.
   * They are those of #velocity. The pressure may be prescribed, too, as it is.
   */
  template <int dim>
  struct NodeConstraint
  {
    unsigned int n_fixed = 0;
    Tensor<2, dim> frame = unit_symmetric_tensor<dim>();
    bool fixed_pressure  = false;
    bool moves           = false; ///< whether a moving boundary prescribes them
    Tensor<1, dim> velocity; ///< of the boundary, mean of the step, m/s; zero in the directions that are free
  };

  /// Unknown (I, component) of a fluid cell has the index I (dim+1) + component; component dim is the pressure.
  template <int dim>
  using LocalVector = std::array<double, (dim + 1) * (dim + 1)>;

  template <int dim>
  using LocalMatrix = std::array<LocalVector<dim>, (dim + 1) * (dim + 1)>;

  /**
   * Eliminate what is prescribed at the corners of a fluid cell from its matrix and its residual: the velocities of
   * corners with a skew frame are turned into it; rows and columns of prescribed unknowns become zero but for the
   * absolute value of the diagonal, their residual becomes zero.
   */
  template <int dim>
  void eliminate_prescribed(const std::array<const NodeConstraint<dim> *, dim + 1> &constraints,
                            LocalMatrix<dim> &matrix, LocalVector<dim> &residual);
} // namespace Lahar

#endif
