// SPDX-License-Identifier: GPL-3.0-or-later

// Test contacts of fluid with solids in the system: their matrix against the dense one, with prescribed components and skew
// frames, and that it is no part of other residuals.

#include <lahar/linear/block_system.h>

#include <algorithm>

#include "tests.h"

using namespace Tests;

template <int dim>
void test_contact()
{
  // A cell of fluid, a linear element, and a contact of the fluid's last node with a facet of the element.
  constexpr unsigned int n = dim + 1;
  typename BlockSystem<dim>::Cell cell;
  SolidPart solid;
  solid.n_nodes = solid.nodes_per_cell = n;
  IndexVector<RegionNode, Point<dim>> positions(2 * n);
  for (unsigned int v = 0; v < n; ++v)
  {
    cell[v] = v;
    solid.cells.push_back(n + v);
    positions[RegionNode(n + v)][0] = 1.;
  }
  solid.contacts.push_back(n - 1);
  for (unsigned int v = 0; v < dim; ++v)
    solid.contacts.push_back(n + v);
  BlockSystem<dim> system(MPI_COMM_SELF);
  system.reinit(n, {cell}, solid, positions);
  check("one contact", system.contacts() == std::vector<unsigned int>{0});

  // A frame turned in the first two components with its first row prescribed; a solid's node that is clamped.
  IndexVector<LocalNode, NodeConstraint<dim>> constraints(2 * n);
  Tensor<2, dim> &frame = constraints[LocalNode(n - 1)].frame;
  frame[0][0] = frame[1][1]             = 0.6;
  frame[0][1]                           = 0.8;
  frame[1][0]                           = -0.8;
  constraints[LocalNode(n - 1)].n_fixed = 1;
  constraints[LocalNode(n)].n_fixed     = dim;
  system.set_constraints(constraints);
  system.set_zero();
  std::array<double, n> weights;
  weights[0] = 1.;
  for (unsigned int v = 1; v < n; ++v)
    weights[v] = v == 1 ? -0.75 : -0.25 / (dim - 1);
  Tensor<1, dim> residual;
  Tensor<2, dim> by_velocity;
  for (unsigned int a = 0; a < dim; ++a)
  {
    residual[a] = 1. + a;
    for (unsigned int b = 0; b < dim; ++b)
      by_velocity[a][b] = 2. + a - 3. * b + (a == b ? 10. : 0.);
  }
  system.add_contact(0, weights, residual, by_velocity);

  double error = 0., rhs_error = 0.;
  const auto turned = [&](const unsigned int node) {
    return node == n - 1 ? frame : Tensor<2, dim>(unit_symmetric_tensor<dim>());
  };
  const auto is_fixed = [&](const unsigned int node, const unsigned int a) {
    return a < constraints[LocalNode(node)].n_fixed;
  };
  for (unsigned int I = 0; I < n; ++I)
  {
    const unsigned int i       = solid.contacts[I];
    const Tensor<1, dim> force = weights[I] * (turned(i) * residual);
    for (unsigned int a = 0; a < dim; ++a)
      rhs_error = std::max(rhs_error, std::abs(system.right_hand_side().block(0)[dim * i + a] +
                                               (is_fixed(i, a) ? 0. : force[a])));
    for (unsigned int J = 0; J < n; ++J)
    {
      const unsigned int j       = solid.contacts[J];
      const Tensor<2, dim> block = weights[I] * weights[J] * (turned(i) * by_velocity * transpose(turned(j)));
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          error = std::max(error, std::abs(system.matrix().block(0, 0).el(dim * i + a, dim * j + b) -
                                           (is_fixed(i, a) || is_fixed(j, b) ? 0. : block[a][b])));
    }
  }
  check("matrix equals the dense one", error, 1e-14);
  check("right-hand side equals the dense one", rhs_error, 1e-14);
  check("they are no part of the other residuals",
        std::all_of(system.momentum_residual().begin(), system.momentum_residual().end(),
                    [](const Tensor<1, dim> &force) { return force.norm() == 0.; }) &&
          std::all_of(system.solid_residual().begin(), system.solid_residual().end(),
                      [](const Tensor<1, dim> &force) { return force.norm() == 0.; }));

  // A contact that goes elsewhere is another pattern.
  const unsigned int pattern = system.pattern_number();
  solid.contacts[0]          = 0;
  system.reinit(n, {cell}, solid, positions);
  check("the matrices follow the contacts", system.pattern_number() == pattern + 1);
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_contact<2>();
  test_contact<3>();
  return n_failed;
}
